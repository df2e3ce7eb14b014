"""Attacks that a hand-in might try, each harmless if it succeeds. Prints a line for each: its name, what became of it, and how.

Arguments: the grader's program, a secret file, a folder that the grader's user can write, and the folder of this file.
Of several lines for one attack the last counts. What is read is not printed.
"""

import errno
import os
import platform
import resource
import signal
import socket
import sys

GRADER, SECRET, OUTSIDE, HERE = sys.argv[1:5]
PARENT = os.getppid()
DECOY = os.path.join(OUTSIDE, "decoy")

try:
    import ctypes

    LIBC = ctypes.CDLL(None, use_errno=True)
except (ImportError, OSError):
    LIBC = None

NUMBERS = {
    "x86_64": dict(
        clone=56, vfork=58, ptrace=101, process_vm_readv=310, process_vm_writev=311, tgkill=234, tkill=200,
        rt_sigqueueinfo=129, execveat=322, memfd_create=319, userfaultfd=323, bpf=321, perf_event_open=298, keyctl=250,
        add_key=248, name_to_handle_at=303, open_by_handle_at=304, unshare=272, setns=308, mount=165, chroot=161,
        pivot_root=155, personality=135, shmget=29, msgget=68, semget=64, mq_open=240, prctl=157, seccomp=317,
        io_setup=206, kcmp=312, setpriority=141, sched_setaffinity=203, prlimit64=302, flock=73, capset=126,
    ),
    "aarch64": dict(
        clone=220, ptrace=117, process_vm_readv=270, process_vm_writev=271, tgkill=131, tkill=130, rt_sigqueueinfo=138,
        execveat=281, memfd_create=279, userfaultfd=282, bpf=280, perf_event_open=241, keyctl=219, add_key=217,
        name_to_handle_at=264, open_by_handle_at=265, unshare=97, setns=268, mount=40, chroot=51, pivot_root=41,
        personality=92, shmget=194, msgget=186, semget=190, mq_open=180, prctl=167, seccomp=277, io_setup=0, kcmp=272,
        setpriority=140, sched_setaffinity=122, prlimit64=261, flock=32, capset=91,
    ),
}.get(platform.machine(), {})
# Calls since 2019 have one number everywhere.
NUMBERS.update(
    pidfd_send_signal=424, io_uring_setup=425, open_tree=428, fsopen=430, pidfd_open=434, clone3=435, openat2=437, pidfd_getfd=438,
    process_madvise=440, memfd_secret=447,
)


class NotTried(Exception):
    pass


def call(name, *arguments):
    """A system call by its name; fails as Python's functions do."""
    if LIBC is None:
        raise NotTried("this Python has no ctypes")
    if name not in NUMBERS:
        raise NotTried("no such call on " + platform.machine())
    # ctypes passes plain integers as 32 bits; a register has 64.
    words = [ctypes.c_long(a) if isinstance(a, int) else a for a in arguments]
    result = LIBC.syscall(ctypes.c_long(NUMBERS[name]), *words)
    if result < 0:
        raise OSError(ctypes.get_errno(), os.strerror(ctypes.get_errno()))
    return result


def probe(name, attack):
    try:
        reached = attack()
    except NotTried as why:
        print(name, "not tried", why, sep="\t", flush=True)
    except OSError as error:
        # What is not there cannot be attacked; a memory address or an argument that the kernel refuses is beyond the sandbox.
        beyond = error.errno in (errno.EFAULT, errno.EINVAL, errno.ENOENT, errno.EBADF)
        print(name, "reached" if beyond else "stopped", error.strerror or error, sep="\t", flush=True)
    except (ValueError, MemoryError) as error:
        print(name, "stopped", error, sep="\t", flush=True)
    else:
        print(name, "stopped" if reached is False else "reached", reached or "", sep="\t", flush=True)


def read(path):
    with open(path, "rb", buffering=0) as file:
        file.read(8)


def opens(path, flags):
    return lambda: os.close(os.open(path, flags))


def makes(path):
    def attack():
        os.close(os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600))
        os.unlink(path)

    return attack


def child(start):
    """Starts a process, which ends at once."""

    def attack():
        process = start()
        if process == 0:
            os._exit(0)
        os.waitpid(process, 0)

    return attack


def spawn():
    return os.posix_spawn("/bin/sh", ["sh", "-c", ":"], {})


def family(number, kind=socket.SOCK_DGRAM):
    def attack():
        try:
            socket.socket(number, kind).close()
        except OSError as error:
            if error.errno in (errno.EAFNOSUPPORT, errno.EPROTONOSUPPORT, errno.ESOCKTNOSUPPORT):
                raise NotTried("this kernel has no such sockets")
            raise

    return attack


def type_into_terminal():
    import fcntl

    # A descriptor that is no terminal refuses in another way than the sandbox does.
    fcntl.ioctl(1, 0x5412, b"#")


def own_signals():
    import fcntl

    fcntl.fcntl(0, fcntl.F_SETOWN, PARENT)


def raises(name):
    def attack():
        soft, hard = resource.getrlimit(name)
        if hard == resource.RLIM_INFINITY:
            return "without a limit"
        resource.setrlimit(name, (hard, hard + 1))

    return attack


def environment():
    known = {"PATH", "LANG", "HOME", "RAYBOOK_ASKED", "PWD", "LC_CTYPE"}
    unknown = [name for name in os.environ if name not in known and not name.startswith("PYTHON")]
    return unknown or False


def descriptors():
    found = []
    for number in range(3, 256):
        try:
            os.fstat(number)
        except OSError:
            continue
        found.append(number)
    return found or False


def shared_memory():
    import mmap

    mmap.mmap(-1, 1 << 16).close()


def address(text):
    return ctypes.c_char_p(text) if LIBC else None


def buffer(size):
    return ctypes.create_string_buffer(size) if LIBC else None


def vector():
    """Two words: an address of ours and a length."""
    if LIBC is None:
        raise NotTried("this Python has no ctypes")
    words = (ctypes.c_size_t * 2)()
    words[0], words[1] = ctypes.addressof(buffer_of_ours), 8
    return words


buffer_of_ours = buffer(64)

in_parent = "/proc/%d/" % PARENT

# Reading.
probe("read a secret file", lambda: read(SECRET))
probe("read it through a link in its own folder", lambda: read(os.path.join(HERE, "link")))
probe("read it by `..`", lambda: read(os.path.join(HERE, "..", os.path.basename(SECRET))))
probe("read it through /proc/self/root", lambda: read("/proc/self/root" + SECRET))
probe("read it through the grader's root", lambda: read(in_parent + "root" + SECRET))
probe("read /etc/passwd", lambda: read("/etc/passwd"))
probe("list the root folder", lambda: len(os.listdir("/")))
probe("list the folder above its own", lambda: len(os.listdir(OUTSIDE)))
probe("list the processes", lambda: len(os.listdir("/proc")))
for part in ("cmdline", "environ", "maps", "auxv", "syscall", "stack"):
    probe("read the grader's " + part, lambda: read(in_parent + part))
# Opened only: to read from a pipe would wait, and take what is another's.
for part in ("mem", "fd/0", "fd/1"):
    probe("read the grader's " + part, opens(in_parent + part, os.O_RDONLY | os.O_NONBLOCK))
probe("list the grader's open files", lambda: len(os.listdir(in_parent + "fd")))
probe("read the grader's program", lambda: read(GRADER))
probe("read a disk", lambda: read(next((d for d in ("/dev/sda", "/dev/vda", "/dev/nvme0n1") if os.path.exists(d)), "/dev/kmsg")))
probe("find the grader's environment", environment)
probe("find an inherited file", descriptors)

# Writing.
for name, folder in (
    ("its own folder", HERE), ("the grader's folder", OUTSIDE), ("/tmp", "/tmp"), ("/var/tmp", "/var/tmp"),
    ("/dev/shm", "/dev/shm"), ("/run", "/run"),
):
    probe("make a file in " + name, makes(os.path.join(folder, "raybook-probe-%d" % os.getpid())))
probe("make a file without a name", opens(OUTSIDE, os.O_WRONLY | getattr(os, "O_TMPFILE", 0)))
probe("write to a file", opens(DECOY, os.O_WRONLY | os.O_APPEND))
probe("cut a file of its own", opens(os.path.join(HERE, "decoy"), os.O_RDONLY | os.O_TRUNC))
probe("cut a file by its name", lambda: os.truncate(DECOY, 5))
probe("change a file's rights", lambda: os.chmod(DECOY, 0o640))
probe("change a file's owner", lambda: os.chown(DECOY, os.getuid(), os.getgid()))
probe("change a file's times", lambda: os.utime(DECOY))
probe("change a file's attributes", lambda: os.setxattr(DECOY, "user.probe", b"1"))
probe("lock a file", lambda: call("flock", 0, 2))
probe("rename a file", lambda: os.rename(DECOY, DECOY))
probe("make a folder", lambda: os.rmdir(os.mkdir(os.path.join(OUTSIDE, "made")) or os.path.join(OUTSIDE, "made")))
probe("make a link", lambda: os.unlink(os.symlink("x", os.path.join(OUTSIDE, "made")) or os.path.join(OUTSIDE, "made")))
probe("make a hard link", lambda: os.unlink(os.link(DECOY, os.path.join(OUTSIDE, "made")) or os.path.join(OUTSIDE, "made")))
probe("make a pipe with a name", lambda: os.unlink(os.mkfifo(os.path.join(OUTSIDE, "made")) or os.path.join(OUTSIDE, "made")))
probe("remove a file", lambda: os.unlink(os.path.join(OUTSIDE, "removed")))
probe("write to the grader's standard output", opens(in_parent + "fd/1", os.O_WRONLY))
probe("write to the grader's memory", opens(in_parent + "mem", os.O_RDWR))
probe("choose who is ended when memory is short", opens(in_parent + "oom_score_adj", os.O_WRONLY))
probe("write to the terminal", opens("/dev/tty", os.O_WRONLY))
probe("write to the kernel's log", opens("/dev/kmsg", os.O_WRONLY))

# Other processes.
probe("start a process by fork", child(os.fork))
probe("start a process by posix_spawn", child(spawn))
probe("start a process by clone", child(lambda: call("clone", int(signal.SIGCHLD), 0, 0, 0, 0)))


def clone3():
    if LIBC is None:
        raise NotTried("this Python has no ctypes")
    words = (ctypes.c_uint64 * 11)()
    words[4] = int(signal.SIGCHLD)
    return call("clone3", words, 88)


probe("start a process by clone3", child(clone3))
probe("leave the session", lambda: os.setsid() or None)
probe("leave the process group", lambda: os.setpgid(0, 0))
probe("signal the grader", lambda: os.kill(PARENT, signal.SIGCONT))
probe("signal everybody", lambda: os.kill(-1, 0))
probe("signal the first process", lambda: os.kill(1, 0))
probe("signal a thread of the grader", lambda: call("tgkill", PARENT, PARENT, 0) and None)
probe("signal the grader as a thread", lambda: call("tkill", PARENT, 0) and None)
probe("queue a signal to the grader", lambda: call("rt_sigqueueinfo", PARENT, int(signal.SIGCONT), buffer(128)) and None)
probe("take a handle of the grader", lambda: os.close(call("pidfd_open", PARENT, 0)))
probe("trace the grader", lambda: call("ptrace", 0x4206, PARENT, 0, 0) and None)
probe("read the grader's memory by a call", lambda: call("process_vm_readv", PARENT, vector(), 1, vector(), 1, 0))
probe("write the grader's memory by a call", lambda: call("process_vm_writev", PARENT, vector(), 1, vector(), 1, 0))
probe("compare its kernel objects with the grader's", lambda: call("kcmp", os.getpid(), PARENT, 1, 0, 0))
probe("limit the grader", lambda: resource.prlimit(PARENT, resource.RLIMIT_CORE))
probe("slow the grader", lambda: os.setpriority(os.PRIO_PROCESS, PARENT, os.getpriority(os.PRIO_PROCESS, PARENT)))
probe("move the grader to a processor", lambda: os.sched_setaffinity(PARENT, os.sched_getaffinity(0)))
probe("let a file's signals go to the grader", own_signals)

# Sockets.
for name, number, kind in (
    ("INET", socket.AF_INET, socket.SOCK_STREAM), ("INET6", socket.AF_INET6, socket.SOCK_STREAM),
    ("UNIX", socket.AF_UNIX, socket.SOCK_STREAM), ("UNIX (datagrams)", socket.AF_UNIX, socket.SOCK_DGRAM),
    ("NETLINK", 16, socket.SOCK_RAW), ("PACKET", 17, socket.SOCK_RAW), ("VSOCK", 40, socket.SOCK_STREAM),
    ("ALG", 38, 5), ("KEY", 15, socket.SOCK_RAW), ("CAN", 29, socket.SOCK_RAW), ("BLUETOOTH", 31, socket.SOCK_RAW), ("XDP", 44, socket.SOCK_RAW),
):
    probe("a socket of family " + name, family(number, kind))
probe("a pair of sockets", lambda: [end.close() for end in socket.socketpair()] and None)

# The terminal, limits, and doors into the kernel.
probe("type into the terminal (TIOCSTI)", type_into_terminal)
for name in ("FSIZE", "CPU", "AS", "DATA", "NOFILE"):
    probe("raise its limit of " + name, raises(getattr(resource, "RLIMIT_" + name)))
probe("outlive the grader", lambda: call("prctl", 1, 0, 0, 0, 0) and None)
probe("shared memory of nobody", shared_memory)
probe("System V memory", lambda: call("shmget", 0, 4096, 0o1600))
probe("System V messages", lambda: call("msgget", 0, 0o1600))
probe("System V semaphores", lambda: call("semget", 0, 1, 0o1600))
probe("a message queue", lambda: call("mq_open", address(b"raybook-probe"), os.O_RDWR | os.O_CREAT, 0o600, 0) and None)
probe("a file in memory", lambda: os.close(call("memfd_create", address(b"probe"), 0)))
probe("a secret file in memory", lambda: os.close(call("memfd_secret", 0)))
probe("run a file by its descriptor", lambda: call("execveat", 1, address(b""), 0, 0, 0x1000))
probe("a file by its handle", lambda: call("name_to_handle_at", -100, address(b"/"), buffer(136), buffer(8), 0))
probe("open a file by its handle", lambda: call("open_by_handle_at", -100, buffer(136), 0))
probe("io_uring", lambda: os.close(call("io_uring_setup", 4, buffer(120))))
probe("asynchronous reading", lambda: call("io_setup", 1, buffer(8)))
probe("userfaultfd", lambda: os.close(call("userfaultfd", 1)))
probe("bpf", lambda: call("bpf", 0, buffer(120), 120))
probe("perf_event_open", lambda: call("perf_event_open", buffer(128), 0, -1, -1, 0))
probe("keyctl", lambda: call("keyctl", 0, -3, 0))
probe("add_key", lambda: call("add_key", address(b"user"), address(b"probe"), address(b"1"), 1, -1) and None)
probe("a user namespace", lambda: call("unshare", 0x10000000))
probe("another namespace", lambda: call("setns", 0, 0))
probe("mount", lambda: call("mount", address(b"none"), address(HERE.encode()), address(b"tmpfs"), 0, 0))
probe("mount by the newer calls", lambda: os.close(call("fsopen", address(b"tmpfs"), 0)))
probe("chroot", lambda: call("chroot", address(b"/")))
probe("change its personality", lambda: call("personality", 0x0040000) and None)
probe("install a filter", lambda: call("seccomp", 1, 0, 0))
probe("take capabilities", lambda: call("capset", buffer(8), buffer(24)))
probe("open by the newer call", lambda: os.close(call("openat2", -100, address(b"/dev/null"), buffer(24), 24)))

# A program that succeeds here takes the place of this one: so it is the last, and the first line stands.
print("run the grader's program", "reached", "", sep="\t", flush=True)
try:
    os.execv(GRADER, [GRADER, "exercise", "--json"])
except OSError as error:
    print("run the grader's program", "stopped", error.strerror, sep="\t", flush=True)
