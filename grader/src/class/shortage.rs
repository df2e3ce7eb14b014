//! Whether the system is short of what a compiler needs. The compiler says so, too, but in words that a hand-in can have it say.

use std::path::{Path, PathBuf};

/// With less room on the disk a compiler may fail, in bytes.
const ROOM: u64 = 64 << 20;

/// What the system is short of, from the beginning of a run on.
#[derive(Debug)]
pub struct Shortage {
    folder: PathBuf,
    ended: Option<u64>,
}

impl Shortage {
    /// Nothing has happened yet. Compilers write into this folder.
    pub fn from_now_on(folder: &Path) -> Self {
        Self {
            folder: folder.to_owned(),
            ended: ended_for_memory(),
        }
    }

    /// Whether the disk is full, or the kernel has ended a process since the beginning because there was no memory.
    pub fn is_there(&self) -> bool {
        room(&self.folder).is_some_and(|room| room < ROOM) || ended_for_memory() != self.ended
    }
}

/// Bytes that can still be written below a folder.
#[cfg(unix)]
fn room(folder: &Path) -> Option<u64> {
    let disk = rustix::fs::statvfs(folder).ok()?;
    Some(disk.f_bavail.saturating_mul(disk.f_frsize))
}

/// The same elsewhere: nothing is known, and no hand-in is compiled.
#[cfg(not(unix))]
fn room(_folder: &Path) -> Option<u64> {
    None
}

/// How many processes the kernel has ended because there was no memory (`oom_kill`, proc(5)); `None` where it does not tell.
fn ended_for_memory() -> Option<u64> {
    let text = std::fs::read_to_string("/proc/vmstat").ok()?;
    let mut lines = text.lines();
    lines
        .find_map(|line| line.strip_prefix("oom_kill "))?
        .parse()
        .ok()
}
