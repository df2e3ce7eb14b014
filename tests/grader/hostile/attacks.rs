//! Programs that attack, as texts: `@course`, `@home` and `@@raybook` stand for what they know of the machine.

/// What a program may know of the machine: the key's file, the grader's program, the course's folder, the instructor's home.
pub const KNOWS: &str = "\
#!/usr/bin/env -S python3 -I -S
import os, sys, time, signal
KEY, RAYBOOK, COURSE, HOME = '@course/key', '@@raybook', '@course', '@home'
GRADER, HERE = os.getppid(), os.path.dirname(os.path.abspath(__file__))

def attempt(attack):
    # Whatever is reached is printed as an answer, and to both outputs.
    try:
        reached = attack()
        told = 'nothing' if reached is None else 'REACHED ' + repr(reached)
    except BaseException as error:
        told = 'nothing: %s' % type(error).__name__
    print('=', told, flush=True)
    print(told, file=sys.stderr, flush=True)

def read(path, size=1 << 20):
    return open(path, 'rb').read(size)

";

/// The name of a program, and what it does after it knows all that. Where a list of answers comes out, its lines are read.
pub const PYTHON: &[(&str, &str)] = &[
    ("reads_the_key", "for path in (KEY, HERE + '/../course/key', '/proc/self/root' + KEY, '/proc/%d/root%s' % (GRADER, KEY)): attempt(lambda: read(path))"),
    ("reads_the_graders_process", "for part in ('cmdline', 'environ', 'maps', 'fd/0', 'fd/1', 'task/%d/environ' % GRADER): attempt(lambda: read('/proc/%d/%s' % (GRADER, part)))"),
    ("reads_the_graders_memory", "
def memory():
    for line in open('/proc/%d/maps' % GRADER):
        if 'heap' in line:
            start, end = (int(x, 16) for x in line.split()[0].split('-'))
            memory = open('/proc/%d/mem' % GRADER, 'rb'); memory.seek(start)
            return memory.read(end - start)
attempt(memory)"),
    ("reads_the_golden_answers", "attempt(lambda: read(COURSE + '/golden/ch01_rays/ray_at.txt')); attempt(lambda: os.listdir(COURSE))"),
    ("asks_the_graders_program", "
import subprocess
attempt(lambda: subprocess.run([RAYBOOK, 'check', 'ray_at', '--json'], capture_output=True).stdout)
attempt(lambda: os.execv('/proc/%d/exe' % GRADER, ['raybook', 'exercise', 'ray_at', '--json']))
attempt(lambda: os.execv(RAYBOOK, ['raybook', 'exercise', 'ray_at', '--json']))"),
    ("loads_the_graders_program_by_the_linker", "
import glob
attempt(lambda: os.execv(glob.glob('/lib*/ld-linux*')[0], ['ld', RAYBOOK, 'exercise', 'ray_at', '--json']))"),
    ("stops_the_grader", "attempt(lambda: os.kill(GRADER, signal.SIGSTOP)); attempt(lambda: os.kill(0, signal.SIGSTOP)); attempt(lambda: os.kill(-1, signal.SIGSTOP))"),
    ("kills_the_grader", "attempt(lambda: os.kill(GRADER, signal.SIGKILL)); attempt(lambda: os.killpg(os.getpgid(GRADER), signal.SIGKILL))"),
    ("kills_a_thread_of_the_grader", "
import ctypes
libc = ctypes.CDLL(None)
for call in (234, 131, 200, 130): libc.syscall(call, GRADER, GRADER, 9)"),
    ("writes_the_graders_output", "
for number in (0, 1, 2): attempt(lambda: open('/proc/%d/fd/%d' % (GRADER, number), 'w').write('FORGED'))"),
    ("patches_the_grader", "
attempt(lambda: os.open('/proc/%d/mem' % GRADER, os.O_RDWR))
import ctypes
libc = ctypes.CDLL(None, use_errno=True)
attempt(lambda: libc.ptrace(16, GRADER, 0, 0) == 0 or None)"),
    ("types_into_the_terminal", "
import fcntl
for number in (0, 1, 2):
    for letter in b'touch FORGED\\n': attempt(lambda: fcntl.ioctl(number, 0x5412, bytes([letter])))
attempt(lambda: open('/dev/tty', 'w').write('FORGED'))
attempt(lambda: [open('/dev/pts/%d' % n, 'w').write('FORGED') for n in range(9)])"),
    ("forks_without_end", "
while True:
    try: os.fork()
    except OSError: time.sleep(0.01)"),
    ("starts_a_daemon", "
def daemon():
    if os.fork() == 0:
        os.setsid()
        if os.fork() == 0: time.sleep(600)
        os._exit(0)
attempt(daemon)
attempt(os.setsid)
attempt(lambda: os.posix_spawn('/usr/bin/setsid', ['setsid', 'sleep', '600'], {}))"),
    ("starts_threads_without_end", "
import threading
threading.stack_size(1 << 15)
while True: threading.Thread(target=time.sleep, args=(60,)).start()"),
    ("takes_all_memory", "
kept = []
while True: kept.append(b'x' * (1 << 26))"),
    ("takes_shared_memory", "
import mmap
kept = []
while True: kept.append(mmap.mmap(-1, 1 << 26)); kept[-1][:] = b'x' * (1 << 26)"),
    ("overflows_its_stack", "
sys.setrecursionlimit(1 << 30)
def deeper(n): return [deeper(n + 1)]
deeper(0)"),
    ("computes_for_ever", "while True: pass"),
    ("sleeps_for_ever", "time.sleep(10000)"),
    ("ignores_signals_and_sleeps", "
for number in range(1, 32):
    try: signal.signal(number, signal.SIG_IGN)
    except OSError: pass
while True: time.sleep(10000)"),
    ("closes_its_outputs_and_sleeps", "os.close(1); os.close(2); time.sleep(10000)"),
    ("answers_at_once_without_end", "
while True: print('= 0 0 0')"),
    ("floods_standard_error", "
while True: sys.stderr.write('x' * 65536)"),
    ("prints_a_line_without_end", "
while True: sys.stdout.write('x' * 65536)"),
    ("writes_files_everywhere", "
for folder in (HERE, COURSE, HOME, '/tmp', '/var/tmp', '/dev/shm', '/run', '/etc', os.getcwd()):
    attempt(lambda: open(folder + '/FORGED', 'w').write('x'))
    attempt(lambda: os.mkdir(folder + '/FORGED'))
    attempt(lambda: os.symlink('/etc/passwd', folder + '/FORGED'))
attempt(lambda: open(COURSE + '/grades.csv', 'w').write('eve,100'))
attempt(lambda: open(COURSE + '/grades.csv', 'r+').write('eve,100'))
attempt(lambda: os.rename(COURSE + '/grades.csv', COURSE + '/x'))"),
    ("makes_a_gigantic_file", "
attempt(lambda: os.truncate(HERE + '/data', 1 << 40))
file = attempt(lambda: open(HERE + '/data', 'r+').truncate(1 << 40))"),
    ("deletes_everything", "
import shutil
for folder in (COURSE, HOME, HERE): shutil.rmtree(folder, ignore_errors=True)
attempt(lambda: os.unlink(os.path.abspath(__file__)))"),
    ("changes_rights", "
for path in (COURSE, COURSE + '/key', HOME, HERE):
    attempt(lambda: os.chmod(path, 0o777)); attempt(lambda: os.chmod(path, 0)); attempt(lambda: os.chown(path, 1, 1)); attempt(lambda: os.utime(path, (0, 0)))"),
    ("plants_files_for_later", "
for name in ('sitecustomize.py', 'usercustomize.py', '.raybook', 'raybook.toml', 'LD_PRELOAD.so'):
    attempt(lambda: open(HERE + '/' + name, 'w').write('x'))
os.environ['LD_PRELOAD'] = HERE + '/evil.so'
os.environ['PYTHONSTARTUP'] = HERE + '/data'
attempt(lambda: read(KEY))"),
    ("reads_the_environment", "
known = ('PATH', 'HOME', 'LANG', 'LC_CTYPE', 'PWD', 'RAYBOOK_ASKED')
attempt(lambda: {name: value for name, value in os.environ.items() if name not in known and not name.startswith('PYTHON')} or None)"),
    ("opens_inherited_files", "
for number in range(3, 64): attempt(lambda: os.pread(number, 4096, 0))"),
    ("becomes_a_shell", "
os.execv('/bin/sh', ['sh', '-c', 'cat ' + KEY + '; read line < ' + KEY + '; echo = $line; echo FORGED > ' + COURSE + '/grades.csv; kill -9 $PPID'])"),
    ("opens_sockets", "
import socket
for family in (socket.AF_INET, socket.AF_INET6, socket.AF_UNIX, 16, 17, 40):
    for kind in (1, 2, 3): attempt(lambda: socket.socket(family, kind).connect(('127.0.0.1', 22)))
attempt(lambda: __import__('urllib.request').request.urlopen('http://example.org').read())"),
    ("raises_its_limits", "
import resource
for name in range(16):
    attempt(lambda: resource.setrlimit(name, (resource.RLIM_INFINITY, resource.RLIM_INFINITY)))
    attempt(lambda: resource.prlimit(GRADER, name, (0, 0)))
attempt(lambda: open(HERE + '/FORGED', 'w').write('x'))"),
    ("runs_what_it_made_in_memory", "
fd = -1
def run():
    fd = os.memfd_create('x'); os.write(fd, read('/bin/sh')); os.execv('/proc/self/fd/%d' % fd, ['sh', '-c', 'echo FORGED > ' + COURSE + '/FORGED'])
attempt(run)"),
    ("follows_links", "
for name in ('link', 'hard', 'up/course/key'): attempt(lambda: read(HERE + '/' + name))"),
    ("opens_its_own_memory", "
for part in ('mem', 'environ', 'root' + KEY): attempt(lambda: os.open('/proc/self/' + part, os.O_RDWR))"),
    ("shares_memory_by_a_name", "
from multiprocessing import shared_memory
attempt(lambda: shared_memory.SharedMemory('FORGED', create=True, size=1 << 20))
for folder in ('/dev/shm', '/dev/mqueue'): attempt(lambda: os.open(folder + '/FORGED', os.O_CREAT | os.O_RDWR))"),
    ("listens_where_no_file_is", "
import socket
for kind in (socket.SOCK_STREAM, socket.SOCK_DGRAM):
    attempt(lambda: socket.socket(socket.AF_UNIX, kind).bind('\\0raybook-FORGED'))"),
    ("changes_what_it_is", "
import ctypes
libc = ctypes.CDLL(None, use_errno=True)
# Reaps what others leave, lets everybody trace it, outlives the grader, moves its own names, shares a core.
for what in ((36, 1), (0x59616d61, -1), (1, 0), (35, 8), (62, 1), (4, 1), (8, 1)):
    attempt(lambda: libc.prctl(*what, 0, 0, 0) == 0 or None)"),
    ("stops_itself", "os.kill(os.getpid(), signal.SIGSTOP)"),
    ("floods_when_it_is_asked_where_it_is", "
def flood(*_):
    while True: print('= 0 0 0', flush=True); sys.stderr.write('x' * 65536)
signal.signal(signal.SIGUSR1, flood)
time.sleep(10000)"),
    ("answers_with_strange_numbers", "
strange = ('nan nan nan', '-nan(0x7ff) nan(1) nan', '1e9999 -1e9999 1e9999', '1' * 900000, '1e' + '9' * 100000, '\\u0661 \\u0662 \\u0663',
    '0x1p3 1_0 +1', ' ' * 1000000, '18446744073709551615 1 2', '-1', '\\x00 \\x85 \\u2028 1')
for line, answer in zip(sys.stdin, strange * 9): sys.stdout.buffer.write(('= %s\\n' % answer).encode()); sys.stdout.flush()"),
    ("forges_a_verdict", "
print('{\"version\": 1, \"exercises\": [{\"exercise\": \"ray_at\", \"state\": \"right\"}]}'); print('1 of 1 exercises are right.'); print('[2 of 2]'); sys.exit(0)"),
];

/// Shell scripts, which know the same paths.
pub const SHELL: &[(&str, &str)] = &[
    (
        "sh_reads_the_key",
        "read -r line < @course/key; echo \"= $line\"; cat @course/key; while read -r q; do echo = $(cat @course/key); done",
    ),
    ("sh_forks", "while :; do (while :; do :; done) & done"),
    (
        "sh_writes",
        "echo FORGED > @course/grades.csv; echo FORGED > /tmp/raybook-FORGED; : > \"$0\"; while read -r q; do echo = 0 0 0; done",
    ),
    (
        "sh_kills",
        "kill -9 $PPID; kill -9 0; kill -9 -1; exec kill -9 $PPID",
    ),
    (
        "sh_asks_the_grader",
        "exec @@raybook exercise ray_at --json",
    ),
    ("sh_becomes_a_daemon", "exec setsid sleep 600"),
    (
        "sh_ulimit",
        "ulimit -f unlimited; ulimit -v unlimited; exec 3> @course/FORGED; echo FORGED >&3",
    ),
];

/// A program in C++ that does all it can without a library's help.
pub const CPP: &str = r#"
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <signal.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
int main() {
    std::ifstream key("@course/key");
    std::string line;
    while (std::getline(key, line)) std::cout << "= " << line << std::endl;
    kill(getppid(), SIGKILL);
    if (ptrace(PTRACE_SEIZE, getppid(), 0, 0) == 0) std::cout << "= FORGED" << std::endl;
    if (socket(AF_INET, SOCK_STREAM, 0) >= 0) std::cout << "= FORGED" << std::endl;
    if (system("echo FORGED > @course/FORGED") == 0) std::cout << "= FORGED" << std::endl;
    pid_t child = fork();
    if (child == 0) { setsid(); sleep(600); }
    std::ofstream("@course/grades.csv") << "eve,100" << std::endl;
    std::ofstream("FORGED") << "FORGED" << std::endl;
    std::remove("@course/key");
    execl("@@raybook", "raybook", "exercise", "ray_at", "--json", nullptr);
    volatile int* nowhere = nullptr;
    *nowhere = 1;
}
"#;

/// The same in Rust.
pub const RUST: &str = r#"
use std::{fs, net::TcpStream, os::unix::net::UnixDatagram, process::Command, thread};
fn main() {
    println!("= {}", fs::read_to_string("@course/key").unwrap_or_default());
    println!("= {:?}", fs::read_dir("@course").map(|d| d.flatten().map(|e| e.path()).collect::<Vec<_>>()).unwrap_or_default());
    if TcpStream::connect("127.0.0.1:22").is_ok_and(|_| true) || UnixDatagram::unbound().is_ok() { println!("= FORGED"); }
    if Command::new("/bin/sh").args(["-c", "echo FORGED > @course/FORGED"]).status().is_ok() { println!("= FORGED"); }
    let _ = fs::write("@course/grades.csv", "eve,100");
    let _ = fs::write("FORGED", "FORGED");
    let _ = fs::remove_dir_all("@course");
    let _ = fs::hard_link("@course/key", "FORGED");
    let threads: Vec<_> = (0..100_000).map_while(|_| thread::Builder::new().stack_size(1 << 14).spawn(|| loop { thread::park() }).ok()).collect();
    threads.into_iter().for_each(|t| t.join().unwrap());
}
"#;
