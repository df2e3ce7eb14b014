//! Counting a program's threads, a build's processes and the bytes that it writes, from outside: no limit of the kernel does it for
//! every user.

use crate::stat::Stat;
use rustix::process::{Pid, PidfdFlags, Signal, kill_process_group, pidfd_open, pidfd_send_signal};
use std::collections::BTreeSet;
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

/// How often threads are counted. A program makes about a hundred in this time.
const EVERY: Duration = Duration::from_millis(4);

/// How often the processes of a build are counted, of all that the machine runs, and the bytes in its folders.
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
        let stat = PathBuf::from(format!("/proc/{process}/stat"));
        while let Some(stat) = Stat::read(&stat).filter(|stat| !stat.has_ended()) {
            if stat.threads > most {
                // Already gone is no error; and if the number is another process's by now, the handle is not.
                let _ = pidfd_send_signal(&handle, Signal::KILL);
                return;
            }
            thread::sleep(EVERY);
        }
    });
}

/// What a build may use that is counted here.
#[derive(Clone, Copy, Debug)]
pub struct Bounds {
    /// Processes at one time.
    pub processes: usize,
    /// Bytes on the disk that are there afterwards and were not before.
    pub bytes: u64,
}

/// Ends a compiler's session when it breaks the bounds, and says how. Goes on until it is told to stop.
pub fn build(
    session: u32,
    folders: &[&Path],
    bounds: Bounds,
    stop: &AtomicBool,
) -> Option<&'static str> {
    let group = i32::try_from(session).ok().and_then(Pid::from_raw)?;
    let written = || folders.iter().map(|folder| bytes_in(folder)).sum::<u64>();
    let before = written();
    let (mut others, mut broken) = (BTreeSet::new(), None);
    while !stop.load(Ordering::Relaxed) {
        if processes_of(session, &mut others) > bounds.processes {
            broken = Some("it started too many processes");
        } else if written().saturating_sub(before) > bounds.bytes {
            broken = Some("it wrote more onto the disk than a program needs");
        }
        if broken.is_some() {
            // No process of the session can leave its group, so all of them end at once. Nobody left is no error.
            let _ = kill_process_group(group, Signal::KILL);
        }
        thread::sleep(BUILDS);
    }
    broken
}

/// The number of processes of a session. `others` are the folders in `/proc` that were seen to be no process of it: no process
/// changes into a session that is there, so these are not read again. Reading them all would take a thirtieth of a build's time.
fn processes_of(session: u32, others: &mut BTreeSet<PathBuf>) -> usize {
    let folders = std::fs::read_dir("/proc").into_iter().flatten().flatten();
    let (mut count, mut seen) = (0, BTreeSet::new());
    for folder in folders.map(|folder| folder.path()) {
        let is_own = |stat: Stat| stat.session == session;
        if !others.contains(&folder) && Stat::read(&folder.join("stat")).is_some_and(is_own) {
            count += 1;
        } else {
            seen.insert(folder);
        }
    }
    *others = seen; // without those that have ended: their numbers may be given out again
    count
}

/// The bytes that the files in a folder, and below it, take on the disk. What vanishes meanwhile takes none.
fn bytes_in(folder: &Path) -> u64 {
    const BLOCK: u64 = 512;
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let bytes = entries.map(|entry| match entry.metadata() {
        Ok(kind) if kind.is_dir() => bytes_in(&entry.path()),
        Ok(file) => BLOCK * file.blocks(),
        Err(_) => 0,
    });
    bytes.sum()
}
