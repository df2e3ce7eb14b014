//! The keys of `raybook watch`, pressed by a person's double: Python, which has terminals of its own.

use super::{new, there_is};
use raybook_grader::language::Language;
use std::fs;
use std::path::Path;
use std::process::Command;

/// Presses each key when the watch waits, or with "early " before it a second later, or saves the file of that name, and says what it printed, how it ended and whether the terminal was left as it was.
const PRESS: &str = r#"
import fcntl, os, pty, select, signal, sys, termios, time
if waited_for := os.fork():
    sys.exit(os.waitstatus_to_exitcode(os.waitpid(waited_for, 0)[1]))
# As a shell does it: a session with a terminal, and in it a group of its own that has the terminal.
os.setsid()
command, words, keys = sys.argv[1], sys.argv[2].split(), sys.argv[3:]
ours, theirs = pty.openpty()
fcntl.ioctl(theirs, termios.TIOCSCTTY, 0)
signal.signal(signal.SIGTTOU, signal.SIG_IGN)
before = termios.tcgetattr(theirs)
child = os.fork()
if child == 0:
    os.setpgid(0, 0)
    os.tcsetpgrp(theirs, os.getpid())
    signal.signal(signal.SIGTTOU, signal.SIG_DFL)
    for fd in (0, 1, 2):
        os.dup2(theirs, fd)
    os.execv(command, [command, "watch", "--plain", *words])
said = b""
def wait(times):
    global said
    while said.count(b"Ctrl-C ends") < times:
        said += os.read(ours, 4096)
times = 0
for key in keys:
    if key.startswith("early "):  # while a check is going on
        end = time.time() + 1
        while select.select([ours], [], [], max(0, end - time.time()))[0]:
            said += os.read(ours, 4096)
        key = key[-1]
    else:
        times += 1
        wait(times)
    if key == "Z":
        os.write(ours, b"\x1a")
        _, status = os.waitpid(child, os.WUNTRACED)
        assert os.WIFSTOPPED(status), status
        assert termios.tcgetattr(theirs) == before, "as it was, while it is stopped"
        os.kill(child, signal.SIGCONT)
        said += b"Ctrl-C ends"
    elif key.endswith(".py"):
        with open(key, "a") as file:
            file.write("\n# saved\n")
    else:
        os.write(ours, b"\x03" if key == "C" else key.encode())
_, status = os.waitpid(child, 0)
os.set_blocking(ours, False)
try:
    said += os.read(ours, 65536)
except OSError:
    pass
print(said.decode(errors="replace"))
print("code", os.waitstatus_to_exitcode(status))
print("as it was" if termios.tcgetattr(theirs) == before else "changed")
"#;

fn press(watched: &str, keys: &[&str]) -> Option<String> {
    press_in(|_| {}, watched, keys)
}

/// The same in a folder that is prepared.
fn press_in(prepare: impl FnOnce(&Path), watched: &str, keys: &[&str]) -> Option<String> {
    if !there_is("python3") {
        return None;
    }
    let home = tempfile::tempdir().expect("a temporary folder");
    let folder = new(home.path(), "rays", Language::Python);
    prepare(&folder);
    let output = Command::new("python3")
        .args(["-c", PRESS, env!("CARGO_BIN_EXE_raybook"), watched])
        .args(keys)
        .current_dir(folder)
        .output()
        .expect("python3 runs");
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    let error = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}{error}");
    Some(said)
}

#[cfg(target_os = "linux")]
#[test]
fn keys_hint_explain_go_on_list_and_quit() {
    let Some(said) = press("", &["h", "h", "h", "h", "e", "n", "l", "Z", "q"]) else {
        return;
    };
    for part in [
        "do one case by hand first",
        "More: raybook hint ray_at --level 3",
        "On the way to the right answer",
        "The way to the right answer",
        "2 High dynamic range",
        "[0 of 2]",
        "not started: ray_at, camera_ray",
        "code 0",
        "as it was",
    ] {
        assert!(said.contains(part), "`{part}` is in: {said}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn who_goes_on_is_followed_to_the_next_chapter() {
    let Some(said) = press("ch01", &["n", "ch02_hdr.py", "q"]) else {
        return;
    };
    let (_, after) = said
        .split_once("ch02_hdr.py changed")
        .unwrap_or_else(|| panic!("the file is seen: {said}"));
    assert!(
        after.contains("Next: write expose") && !after.contains("camera_ray"),
        "the chapter that n leads to is checked: {after}"
    );
}

/// A function that never ends keeps the check busy, but not the keys.
#[cfg(target_os = "linux")]
#[test]
fn keys_are_obeyed_while_a_check_goes_on() {
    let endless = |folder: &Path| {
        let file = folder.join("ch01_rays.py");
        let text = fs::read_to_string(&file).expect("there is a stub");
        let text = text.replace("raise NotImplementedError(\"ray_at\")", "while True: pass");
        fs::write(file, text).expect("it can be written");
    };
    let Some(said) = press_in(endless, "ray_at", &["early l", "early h", "early q"]) else {
        return;
    };
    for part in [
        "not checked: ray_at, camera_ray",
        "h comes next",
        "code 0",
        "as it was",
    ] {
        assert!(said.contains(part), "`{part}` is in: {said}");
    }
    assert!(!said.contains("0 of 40"), "it has not ended: {said}");
}

#[cfg(target_os = "linux")]
#[test]
fn ctrl_c_leaves_the_terminal_as_it_was() {
    let Some(said) = press("", &["C"]) else {
        return;
    };
    assert!(
        said.contains("code 130") && said.contains("as it was"),
        "{said}"
    );
}
