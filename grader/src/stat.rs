//! What Linux tells of a process or a thread (proc(5), `/proc/pid/stat`).

use nix::unistd::getpgid;
use rustix::process::Pid;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// The part that the grader looks at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stat {
    /// A letter: `R` is running, `Z` has ended.
    pub state: u8,
    /// The number of its session.
    pub session: u32,
    /// Processor time, in ticks: its own and that of its children that have ended, for itself and for the system.
    pub ticks: u64,
    /// The number of threads of the process.
    pub threads: usize,
}

impl Stat {
    /// What a file `stat` tells; `None` if the process is gone.
    pub(crate) fn read(file: &Path) -> Option<Self> {
        Self::of(&std::fs::read(file).ok()?)
    }

    /// What the text of such a file tells.
    pub fn of(text: &[u8]) -> Option<Self> {
        // The name before may hold anything, but no other bracket follows it.
        let end = text.iter().rposition(|&byte| byte == b')')?;
        let rest = String::from_utf8_lossy(&text[end + 1..]);
        let words: Vec<_> = rest.split_ascii_whitespace().collect();
        let ticks = words.get(11..15)?.iter();
        Some(Self {
            state: *words.first()?.as_bytes().first()?,
            session: words.get(3)?.parse().ok()?,
            ticks: ticks.filter_map(|word| word.parse::<u64>().ok()).sum(),
            threads: words.get(17)?.parse().ok()?,
        })
    }

    /// Whether it has ended, and only its number is left.
    pub fn has_ended(&self) -> bool {
        matches!(self.state, b'Z' | b'X')
    }
}

/// Every process of the machine, and its folder in `/proc`.
pub(crate) fn processes() -> impl Iterator<Item = (Pid, PathBuf)> {
    let folders = std::fs::read_dir("/proc").into_iter().flatten().flatten();
    folders.filter_map(|folder| {
        let number = folder.file_name().to_str()?.parse().ok()?;
        Some((Pid::from_raw(number)?, folder.path()))
    })
}

/// Whether a process is of the group of this number: far sooner known than by its `stat`, for programs end by the thousand. (nix, since
/// rustix knows no group 0, which the kernel's own processes have.)
pub(crate) fn is_in_group(process: Pid, group: u32) -> bool {
    let process = nix::unistd::Pid::from_raw(process.as_raw_nonzero().get());
    getpgid(Some(process)).is_ok_and(|of| of.as_raw().unsigned_abs() == group)
}

/// How long this thread could have gone on since it began, and waited for a processor (`/proc/thread-self/schedstat`, in nanoseconds).
pub(crate) fn waited() -> Duration {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    let waited = text.split_ascii_whitespace().nth(1);
    Duration::from_nanos(waited.and_then(|word| word.parse().ok()).unwrap_or(0))
}
