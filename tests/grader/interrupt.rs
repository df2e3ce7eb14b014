//! Ctrl-C ends the grader, and with it everything that a student's program has started.
#![cfg(target_os = "linux")] // where processes are listed in /proc

use crate::common::executable;

use std::fs;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

#[test]
fn nothing_is_left_when_the_grader_is_interrupted() {
    for signal in ["INT", "TERM", "HUP"] {
        // A number that no other process on this machine sleeps for.
        let seconds = format!("97{:06}", std::process::id() % 1_000_000);
        let folder = tempfile::tempdir().expect("a temporary folder");
        let program = folder.path().join("endless");
        let script = format!(
            "#!/bin/sh\nsetsid sleep {seconds} &\nsleep {seconds} &\nwhile true; do sleep {seconds}; done\n"
        );
        executable::script(&program, &script);
        let mut grader = Command::new(env!("CARGO_BIN_EXE_raybook"))
            .args([
                "check",
                "ray_at",
                "--time-limit",
                "60",
                "--trust",
                "--program",
            ])
            .arg(&program)
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("the command starts");
        assert!(
            becomes(3, &seconds),
            "the program starts its three processes"
        );
        let sent = Command::new("kill")
            .args(["-s", signal, &grader.id().to_string()])
            .status();
        assert!(sent.is_ok_and(|sent| sent.success()), "{signal} is sent");
        let ended = grader.wait().expect("the grader can be waited for");
        assert_eq!(ended.code(), Some(130), "{signal} ends the grader");
        assert!(becomes(0, &seconds), "{signal}: no process is left");
    }
}

/// Whether `count` processes sleep for this number of seconds, within ten seconds from now.
fn becomes(count: usize, seconds: &str) -> bool {
    let deadline = Instant::now() + Duration::from_secs(10);
    while Instant::now() < deadline {
        if sleepers(seconds) == count {
            return true;
        }
        sleep(Duration::from_millis(10));
    }
    false
}

fn sleepers(seconds: &str) -> usize {
    let entries = fs::read_dir("/proc").into_iter().flatten().flatten();
    let commands = entries.filter_map(|entry| fs::read(entry.path().join("cmdline")).ok());
    commands
        .filter(|command| command.starts_with(format!("sleep\0{seconds}").as_bytes()))
        .count()
}
