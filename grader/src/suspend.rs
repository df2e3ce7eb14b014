//! Ctrl-Z stops the grader with all that it started, and the time until it goes on is nobody's.

#[cfg(unix)]
use crate::mutex::lock;
use crate::{contain, keys};
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// How long the grader has been stopped in all. It is locked while it is stopped.
static STOPPED: Mutex<Duration> = Mutex::new(Duration::ZERO);

/// The time by a clock that stands still while the grader is stopped.
pub(crate) fn now() -> Instant {
    let stopped = lock(&STOPPED);
    let now = Instant::now();
    now.checked_sub(*stopped).unwrap_or(now)
}

/// Stops the grader and the programs that it asks, until somebody lets it go on.
#[cfg(unix)]
pub(crate) fn suspend() {
    let mut stopped = lock(&STOPPED);
    let since = Instant::now();
    let held = contain::stop_all();
    keys::as_before(stop_here);
    drop(held); // and they go on
    *stopped += since.elapsed();
}

/// From now on Ctrl-Z and its signal suspend. It must be called before the first thread is started.
#[cfg(unix)]
pub(crate) fn suspend_on_signals() {
    let signal = signal();
    if signal.thread_block().is_ok() {
        std::thread::spawn(move || {
            while signal.wait().is_ok() {
                suspend();
            }
        });
    }
}

/// Stops this process as the signal does by itself; the system refuses where there is no shell that could wake it again.
#[cfg(unix)]
fn stop_here() {
    let signal = signal();
    if signal.thread_unblock().is_ok() {
        let _ = nix::sys::signal::raise(nix::sys::signal::Signal::SIGTSTP);
        let _ = signal.thread_block();
    }
}

#[cfg(unix)]
fn signal() -> nix::sys::signal::SigSet {
    nix::sys::signal::Signal::SIGTSTP.into()
}

/// No such signal on this system.
#[cfg(not(unix))]
pub(crate) fn suspend_on_signals() {}
