//! Where the command's output goes: to someone who reads on, or not; to a full disk; nowhere.

#![cfg(target_os = "linux")] // where there is a /dev/full

use std::fs::{File, OpenOptions};
use std::process::{Command, ExitStatus, Stdio};

const RAYBOOK: &str = env!("CARGO_BIN_EXE_raybook");

fn full() -> File {
    let file = OpenOptions::new().write(true).open("/dev/full");
    file.expect("Linux has a full disk")
}

/// How the command ends with these outputs, and what it says on standard error if that is piped.
fn ends(arguments: &[&str], stdout: Stdio, stderr: Stdio) -> (ExitStatus, String) {
    let home = tempfile::tempdir().expect("a temporary folder");
    let output = Command::new(RAYBOOK)
        .args(arguments)
        .current_dir(home.path())
        .stdin(Stdio::null())
        .stdout(stdout)
        .stderr(stderr)
        .output()
        .expect("the command runs");
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    (output.status, said)
}

/// A pipe that nobody reads.
fn broken() -> Stdio {
    let (reader, writer) = std::io::pipe().expect("a pipe");
    drop(reader);
    writer.into()
}

/// Commands that say much, with their exit codes.
const TALKATIVE: [(&[&str], i32); 4] = [
    (&[], 0),
    (&["exercise", "ray_at"], 0),
    (&["exercise", "--json"], 0),
    (&["check", "ray_at", "--program", "/bin/false"], 1),
];

#[test]
fn who_stops_reading_is_no_error() {
    for (arguments, code) in TALKATIVE {
        let (status, said) = ends(arguments, broken(), Stdio::piped());
        assert_eq!(status.code(), Some(code), "{arguments:?}: {said}");
        assert_eq!(said, "", "{arguments:?}: and is not spoken of");
    }
}

#[test]
fn a_full_disk_is_an_error() {
    for (arguments, _) in TALKATIVE {
        let (status, said) = ends(arguments, full().into(), Stdio::piped());
        assert_eq!(status.code(), Some(2), "{arguments:?}: {said}");
        assert!(
            said.contains("standard output cannot be written") && said.contains("No space left"),
            "{arguments:?}: {said}"
        );
    }
}

#[test]
fn a_standard_error_that_cannot_be_written_is_no_panic() {
    let wrong = ["check", "no_such_exercise"];
    for stderr in [full().into(), broken()] {
        let (status, _) = ends(&wrong, Stdio::null(), stderr);
        assert_eq!(
            status.code(),
            Some(2),
            "the usage is wrong, and that is all"
        );
    }
    let (status, _) = ends(&["exercise", "ray_at"], full().into(), full().into());
    assert_eq!(status.code(), Some(2), "nothing can be said at all");
}

#[test]
fn closed_outputs_are_no_panic() {
    for (arguments, code) in [("check no_such_exercise", 2), ("exercise ray_at", 0)] {
        for closed in [">&-", "2>&-", ">&- 2>&-", "<&- >&- 2>&-"] {
            let script = format!("{RAYBOOK:?} {arguments} {closed}");
            let status = Command::new("/bin/sh")
                .args(["-c", &script])
                .stdout(Stdio::null())
                .stderr(Stdio::null())
                .status();
            let status = status.expect("the shell runs");
            assert_eq!(status.code(), Some(code), "{script}");
        }
    }
}
