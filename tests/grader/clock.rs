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

/// What a time limit of 20 ms made of a shell script.
struct Measured {
    /// Until the time was over.
    wall: Duration,
    /// Of it, what the busy machine took.
    lost: Duration,
    /// Processor time.
    used: Duration,
}

const LIMIT: Duration = Duration::from_millis(20);

/// Measures a script that is nicer than others, from when it is at work or sleeps.
fn measured(script: &str, at_work: bool) -> Measured {
    let mut child = Command::new("nice")
        .args(["-n", "10", "sh", "-c", script])
        .process_group(0)
        .spawn()
        .expect("a shell");
    thread::sleep(Duration::from_millis(500)); // for a shell that starts may wait too
    while usage(child.id()).is_some_and(|usage| usage.at_work != at_work) {
        thread::sleep(Duration::from_millis(10));
    }
    let time = || usage(child.id()).expect("it runs").time;
    let (before, start, mut clock) = (time(), Instant::now(), Clock::new(Some(child.id())));
    while !clock.is_over(LIMIT, Duration::ZERO) {
        thread::sleep(clock.next_look(LIMIT).duration_since(Instant::now()));
    }
    let measured = Measured {
        wall: start.elapsed(),
        lost: clock.lost(),
        used: time().saturating_sub(before),
    };
    child.kill().expect("it is ended");
    child.wait().expect("it ends");
    measured
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
    let sleeps = measured("exec sleep 100", false);
    assert!(sleeps.lost < sleeps.wall / 2, "of a program that sleeps");
    let works = on_a_busy_machine(|| measured("while :; do :; done", true));
    assert!(works.lost > works.wall / 2, "of one that would work");
    // It has a hundredth of a processor.
    assert!(
        works.used >= LIMIT / 2,
        "it was ended after {:?}",
        works.used
    );
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
        [longer, far_longer, Duration::ZERO].map(|time| budget.over(time, 0))
    };
    let over = |over: &Option<Over>| matches!(over, Some(Over::Time(Whole::Exercise, _)));
    let [soon, late, after] = on_a_busy_machine(work);
    assert_eq!(soon, None);
    assert!(over(&late), "a tenth of all time counts");
    assert_eq!(after, late, "what is over stays over");
    // Whom a busy machine wakes late is forgiven that, but not each time.
    let sleep = || {
        let mut budget = Budget::new(&limits);
        thread::sleep(longer);
        budget.over(longer, 0)
    };
    let blamed = (0..20).any(|_| over(&sleep()));
    assert!(blamed, "who sleeps is blamed");
}
