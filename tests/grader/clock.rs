//! Time for an answer, on a busy machine.

#![cfg(target_os = "linux")] // elsewhere nobody tells what a program has used

use raybook_grader::budget::{Over, Whole};
use raybook_grader::converse::Limits;
use raybook_grader::inside::{Budget, Clock, usage};
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

/// What becomes true beside programs that take all of the processor, eight for each core.
fn on_a_busy_machine<T>(run: impl FnOnce() -> T) -> T {
    let stop = AtomicBool::new(false);
    thread::scope(|scope| {
        for _ in 0..8 * thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                while !stop.load(Ordering::Relaxed) {
                    std::hint::spin_loop();
                }
            });
        }
        let result = run();
        stop.store(true, Ordering::Relaxed);
        result
    })
}

#[test]
fn what_a_busy_machine_takes_is_told_from_sleep() {
    let sleeps = lost("exec sleep 100", false);
    assert!(sleeps < 0.5, "of a program that sleeps: {sleeps}");
    let works = on_a_busy_machine(|| lost("while :; do :; done", true));
    assert!(works > 0.5, "of one that would work: {works}");
}

#[test]
fn a_busy_machine_takes_nothing_from_the_time_of_all_answers() {
    // Longer than the limit on the slowest machine, of eight times as much; and less than ten times the limit.
    let [limit, longer, far_longer] = [10, 90, 1000].map(Duration::from_millis);
    let mut limits = Limits::of(Duration::from_secs(5));
    limits.exercise.time = limit;
    // Most of the time that this thread works, others have the processor.
    let work = || {
        let (mut budget, start) = (Budget::new(&limits), Instant::now());
        while start.elapsed() < 2 * longer {
            std::hint::spin_loop();
        }
        [longer, far_longer].map(|time| budget.over(time, 0))
    };
    let over = |over: &Option<Over>| matches!(over, Some(Over::Time(Whole::Exercise, _)));
    let [soon, late] = on_a_busy_machine(work);
    assert_eq!(soon, None);
    assert!(over(&late), "a tenth of all time counts");
    let mut budget = Budget::new(&limits);
    thread::sleep(longer);
    assert!(over(&budget.over(longer, 0)), "who sleeps is blamed");
}
