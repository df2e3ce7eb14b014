//! Ctrl-C ends the grader, and with it everything that a student's program has started.
#![cfg(target_os = "linux")] // where processes are listed in /proc

use crate::common::executable;

use std::fs;
use std::os::unix::process::CommandExt;
use std::path::Path;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// The command that asks a program, which has a minute for each answer, and says nothing.
fn check(program: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_raybook"));
    command
        .args(["check", "ray_at", "--time-limit", "60", "--trust"])
        .arg("--program")
        .arg(program)
        .stdout(Stdio::null())
        .stderr(Stdio::null());
    command
}

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
        let mut grader = check(&program).spawn().expect("the command starts");
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

#[test]
fn who_stops_the_grader_stops_the_program_too() {
    // A number that no other process on this machine sleeps for.
    let seconds = format!("96{:06}", std::process::id() % 1_000_000);
    let folder = tempfile::tempdir().expect("a temporary folder");
    let program = folder.path().join("endless");
    executable::script(&program, &format!("#!/bin/sh\nexec sleep {seconds}\n"));
    let mut grader = check(&program)
        .process_group(0) // as a shell does it
        .spawn()
        .expect("the command starts");
    assert!(becomes(1, &seconds), "the program starts");
    let send = |signal: &str| {
        let sent = Command::new("kill")
            .args(["-s", signal, &grader.id().to_string()])
            .status();
        assert!(sent.is_ok_and(|sent| sent.success()), "{signal} is sent");
    };
    let stopped = || {
        let own = PathBuf::from(format!("/proc/{}", grader.id()));
        let all = sleepers(&seconds).into_iter().chain([own]);
        all.filter(|process| {
            let stat = fs::read_to_string(process.join("stat")).unwrap_or_default();
            stat.rsplit(") ")
                .next()
                .is_some_and(|rest| rest.starts_with('T'))
        })
        .count()
    };
    for (signal, count) in [("TSTP", 2), ("CONT", 0), ("TSTP", 2), ("CONT", 0)] {
        send(signal);
        assert!(
            within(|| stopped() == count),
            "{signal}: {} stand",
            stopped()
        );
    }
    send("INT");
    let ended = grader.wait().expect("the grader can be waited for");
    assert_eq!(ended.code(), Some(130), "it can be ended afterwards");
    assert!(becomes(0, &seconds), "no process is left");
}

#[test]
fn the_time_for_an_answer_stands_still_while_the_grader_is_stopped() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let [program, asked, go] = ["answers", "asked", "go"].map(|name| folder.path().join(name));
    let script = format!(
        "#!/bin/sh\nread -r line; echo '= 0 0 0'\nread -r line; >{}\nwhile [ ! -e {} ]; do sleep 0.02; done\necho '= 0 0 0'\nwhile read -r line; do echo '= 0 0 0'; done\n",
        asked.display(),
        go.display()
    );
    executable::script(&program, &script);
    let mut command = Command::new(env!("CARGO_BIN_EXE_raybook"));
    let grader = command
        .args(["check", "ray_at", "--plain", "--time-limit", "3", "--trust"])
        .arg("--program")
        .arg(&program)
        .process_group(0)
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .expect("the command starts");
    let send = |signal: &str| {
        let sent = Command::new("kill")
            .args(["-s", signal, &grader.id().to_string()])
            .status();
        assert!(sent.is_ok_and(|sent| sent.success()), "{signal} is sent");
    };
    assert!(within(|| asked.exists()), "the second question is asked");
    send("TSTP");
    sleep(Duration::from_secs(4)); // longer than the answer may take
    fs::write(&go, "").expect("the answer may come");
    send("CONT");
    let said = grader.wait_with_output().expect("it can be waited for");
    let said = String::from_utf8_lossy(&said.stdout);
    assert!(
        said.contains("40 of the 40 wrong ones"),
        "every answer came in time: {said}"
    );
}

/// Whether `count` processes sleep for this number of seconds, within a minute from now.
fn becomes(count: usize, seconds: &str) -> bool {
    within(|| sleepers(seconds).len() == count)
}

/// Whether something becomes true within a minute from now.
fn within(is_so: impl Fn() -> bool) -> bool {
    let deadline = Instant::now() + Duration::from_secs(60);
    while Instant::now() < deadline {
        if is_so() {
            return true;
        }
        sleep(Duration::from_millis(10));
    }
    false
}

fn sleepers(seconds: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir("/proc").into_iter().flatten().flatten();
    let sleeps = |process: &PathBuf| {
        let command = fs::read(process.join("cmdline")).unwrap_or_default();
        command.starts_with(format!("sleep\0{seconds}").as_bytes())
    };
    entries.map(|entry| entry.path()).filter(sleeps).collect()
}
