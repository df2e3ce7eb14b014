//! A build, whose processes and bytes are counted.

use raybook_grader::inside::sandbox::{Bounds, build};
use std::os::unix::process::ExitStatusExt;
use std::process::Command;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;

/// How a shell script ends that is watched as a build, and what it broke.
fn watched(script: &str) -> (Option<i32>, Option<&'static str>) {
    let bounds = Bounds {
        processes: 20,
        bytes: 4 << 20,
    };
    let folder = tempfile::tempdir().expect("a temporary folder");
    std::fs::write(folder.path().join("before"), vec![1; 8 << 20]).expect("a file");
    let mut child = Command::new("setsid")
        .args(["sh", "-c", script])
        .current_dir(folder.path())
        .spawn()
        .expect("a shell");
    let (session, ended) = (child.id(), AtomicBool::new(false));
    thread::scope(|scope| {
        let watched = scope.spawn(|| build(session, &[folder.path()], bounds, &ended));
        let status = child.wait().expect("it ends");
        ended.store(true, Ordering::Relaxed);
        (status.signal(), watched.join().expect("it ends"))
    })
}

#[test]
fn a_build_of_too_many_processes_is_ended() {
    let starts = |count: u32| {
        format!("i=0; while [ $i -lt {count} ]; do sleep 1 & i=$((i + 1)); done; wait")
    };
    let ended = Some("it started too many processes");
    assert_eq!(watched(&starts(30)), (Some(9), ended));
    assert_eq!(watched(&starts(10)), (None, None), "with the shell, 11");
}

#[test]
fn who_fills_the_disk_is_ended() {
    let fills = "mkdir a; i=0; while i=$((i + 1)); do head -c 999999 /dev/zero > a/$i; done";
    assert_eq!(
        watched(fills),
        (
            Some(9),
            Some("it wrote more onto the disk than a program needs")
        )
    );
    assert_eq!(
        watched("echo > x; sleep 0.2"),
        (None, None),
        "and nobody else"
    );
}
