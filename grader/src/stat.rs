//! What Linux tells of a process or a thread (proc(5), `/proc/pid/stat`).

use std::path::{Path, PathBuf};

/// The part that the grader looks at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Stat {
    /// A letter: `R` is running, `Z` has ended.
    pub state: u8,
    /// The number of its process group.
    pub group: u32,
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

    /// Every process of the machine: its folder in `/proc`, and what that tells.
    pub(crate) fn of_all() -> impl Iterator<Item = (PathBuf, Self)> {
        let folders = std::fs::read_dir("/proc").into_iter().flatten().flatten();
        folders.filter_map(|folder| {
            let stat = Self::read(&folder.path().join("stat"))?;
            Some((folder.path(), stat))
        })
    }

    fn of(text: &[u8]) -> Option<Self> {
        // The name before may hold anything, but no other bracket follows it.
        let end = text.iter().rposition(|&byte| byte == b')')?;
        let rest = String::from_utf8_lossy(&text[end + 1..]);
        let words: Vec<_> = rest.split_ascii_whitespace().collect();
        let ticks = words.get(11..15)?.iter();
        Some(Self {
            state: *words.first()?.as_bytes().first()?,
            group: words.get(2)?.parse().ok()?,
            session: words.get(3)?.parse().ok()?,
            ticks: ticks.filter_map(|word| word.parse::<u64>().ok()).sum(),
            threads: words.get(17)?.parse().ok()?,
        })
    }

    /// Whether it has ended, and only its number is left.
    pub(crate) fn has_ended(&self) -> bool {
        matches!(self.state, b'Z' | b'X')
    }
}

#[cfg(test)]
mod tests {
    use super::Stat;

    #[test]
    fn it_is_read_whatever_the_name() {
        let text = "12 (a) b (c) S 1 13 14 0 -1 4194560 92 0 0 0 1 2 3 4 20 0 7 0 100 1 2";
        let stat = Stat {
            state: b'S',
            group: 13,
            session: 14,
            ticks: 10,
            threads: 7,
        };
        assert_eq!(Stat::of(text.as_bytes()), Some(stat));
        assert!(!stat.has_ended(), "it sleeps");
        let ended = Stat::of(text.replace(") S", ") Z").as_bytes());
        assert!(ended.is_some_and(|stat| stat.has_ended()));
        assert_eq!(Stat::of(b"12 (cut off"), None);
    }
}
