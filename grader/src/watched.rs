//! The files of a workbook that a student edits, and which of them changed.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

/// Folders that are made, not written.
const MADE: [&str; 4] = ["target", "build", "out", "__pycache__"];

/// How many folders deep files are looked for.
const DEEP: usize = 8;

/// The files of a folder by their paths in it, each with its time and its length.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Snapshot(BTreeMap<PathBuf, (Option<SystemTime>, u64)>);

impl Snapshot {
    /// The files as they are now, without hidden ones and without what is made of them. What cannot be read is not there.
    pub fn of(folder: &Path) -> Self {
        let mut seen = Self::default();
        seen.look(folder, Path::new(""), DEEP);
        seen
    }

    fn look(&mut self, folder: &Path, inside: &Path, deep: usize) {
        let entries = fs::read_dir(folder.join(inside)).into_iter().flatten();
        for entry in entries.flatten() {
            let name = entry.file_name();
            let hidden = name.to_string_lossy().starts_with('.');
            let made = MADE.iter().any(|made| name == *made);
            let path = inside.join(&name);
            let Ok(kind) = entry.metadata() else { continue };
            if kind.is_dir() && !hidden && !made && deep > 0 {
                self.look(folder, &path, deep - 1);
            } else if kind.is_file() && !hidden {
                let seen = (kind.modified().ok(), kind.len());
                self.0.insert(path, seen);
            }
        }
    }
}

/// The files that are new, gone or different.
pub fn changed(before: &Snapshot, after: &Snapshot) -> Vec<PathBuf> {
    let all = before.0.keys().chain(after.0.keys());
    let mut files: Vec<_> = all
        .filter(|path| before.0.get(*path) != after.0.get(*path))
        .cloned()
        .collect();
    files.sort();
    files.dedup();
    files
}
