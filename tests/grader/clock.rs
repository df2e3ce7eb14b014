//! Time for an answer, on a busy machine.

#![cfg(target_os = "linux")] // elsewhere nobody tells what a program has used

use raybook_grader::inside::{Clock, usage};
use std::os::unix::process::CommandExt;
use std::process::Command;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};

/// How much of its time on the wall a shell script lost while it was measured, from when it is at work or sleeps.
fn lost(script: &str, at_work: bool) -> f64 {
    let mut child = Command::new("nice")
        .args(["-n", "19", "sh", "-c", script])
        .process_group(0)
        .spawn()
        .expect("a shell");
    thread::sleep(Duration::from_millis(500)); // for a shell that starts may wait too
    while usage(child.id()).is_some_and(|usage| usage.at_work != at_work) {
        thread::sleep(Duration::from_millis(10));
    }
    let (start, mut clock) = (Instant::now(), Clock::new(Some(child.id())));
    let limit = Duration::from_millis(100);
    while !clock.is_over(limit, Duration::ZERO) {
        thread::sleep(clock.next_look(limit).duration_since(Instant::now()));
    }
    let lost = clock.lost().as_secs_f64() / start.elapsed().as_secs_f64();
    child.kill().expect("it is ended");
    child.wait().expect("it ends");
    lost
}

#[test]
fn what_a_busy_machine_takes_is_told_from_sleep() {
    let sleeps = lost("exec sleep 100", false);
    assert!(sleeps < 0.5, "of a program that sleeps: {sleeps}");
    let stop = AtomicBool::new(false);
    thread::scope(|scope| {
        for _ in 0..4 * thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                while !stop.load(Ordering::Relaxed) {
                    std::hint::spin_loop();
                }
            });
        }
        let works = lost("while :; do :; done", true);
        stop.store(true, Ordering::Relaxed);
        assert!(works > 0.5, "of one that would work: {works}");
    });
}
