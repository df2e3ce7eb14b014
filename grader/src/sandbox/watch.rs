//! Counting a program's threads, and a build's processes, from outside: no limit of the kernel does it for every user.

use rustix::process::{Pid, PidfdFlags, Signal, kill_process_group, pidfd_open, pidfd_send_signal};
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

/// How often threads are counted. A program makes about a hundred in this time.
const EVERY: Duration = Duration::from_millis(4);

/// How often the processes of a build are counted, of all that the machine runs.
const BUILDS: Duration = Duration::from_millis(50);

/// Ends the process when it has more threads than these. Goes on by itself until the process ends.
pub fn threads(process: u32, most: usize) {
    let Some(pid) = i32::try_from(process).ok().and_then(Pid::from_raw) else {
        return;
    };
    // The process has not been waited for yet: the number is its own. A kernel with landlock has these descriptors.
    let Ok(handle) = pidfd_open(pid, PidfdFlags::empty()) else {
        return;
    };
    thread::spawn(move || {
        let stat = format!("/proc/{process}/stat");
        while let Some(count) = std::fs::read_to_string(&stat)
            .ok()
            .as_deref()
            .and_then(count)
        {
            if count > most {
                // Already gone is no error; and if the number is another process's by now, the handle is not.
                let _ = pidfd_send_signal(&handle, Signal::KILL);
                return;
            }
            thread::sleep(EVERY);
        }
    });
}

/// Ends a compiler's session when it has more processes than these. Goes on until it is told to stop.
pub fn processes(session: u32, most: usize, stop: &AtomicBool) {
    let Some(group) = i32::try_from(session).ok().and_then(Pid::from_raw) else {
        return;
    };
    while !stop.load(Ordering::Relaxed) {
        let stats = std::fs::read_dir("/proc").into_iter().flatten().flatten();
        let stats =
            stats.filter_map(|entry| std::fs::read_to_string(entry.path().join("stat")).ok());
        if stats
            .filter(|stat| session_of(stat) == Some(session))
            .count()
            > most
        {
            // No process of the session can leave its group, so all of them end at once. Nobody left is no error.
            let _ = kill_process_group(group, Signal::KILL);
        }
        thread::sleep(BUILDS);
    }
}

/// The session, in the text of `/proc/…/stat`.
fn session_of(stat: &str) -> Option<u32> {
    // After the name: state, parent, group, session.
    stat.rsplit_once(')')?
        .1
        .split_whitespace()
        .nth(3)?
        .parse()
        .ok()
}

/// The number of threads, in the text of `/proc/…/stat`; none of a process that has ended.
fn count(stat: &str) -> Option<usize> {
    /// Fields between the state and it.
    const BETWEEN: usize = 16;
    // The name, in parentheses, may hold anything.
    let mut fields = stat.rsplit_once(')')?.1.split_whitespace();
    let state = fields.next()?;
    let count = fields.nth(BETWEEN)?.parse().ok()?;
    (state != "Z" && state != "X").then_some(count)
}

#[cfg(test)]
mod tests {
    use super::{count, session_of};

    #[test]
    fn threads_are_counted_whatever_the_name() {
        let stat = |state| {
            format!("12 (a) b (c) {state} 1 12 12 0 -1 4194560 92 0 0 0 0 0 0 0 20 0 7 0 100 1 2")
        };
        assert_eq!(count(&stat("S")), Some(7), "in the twentieth field");
        assert_eq!(count(&stat("Z")), None, "it has ended");
        assert_eq!(session_of(&stat("S")), Some(12), "in the sixth field");
    }
}
