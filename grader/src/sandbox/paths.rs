//! Which files a program may read: whole folders, less what is hidden in them.

use std::path::{Path, PathBuf};

/// What a rule of landlock is to be made for.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Readable {
    /// A file, or a folder with all that is in it: it may be read and executed.
    All(PathBuf),
    /// A folder in which something is hidden: names may be listed here and below, and nothing more.
    Names(PathBuf),
}

/// Rules for all of `root` but `hidden`, which are canonical paths. Links are not followed: what they lead to has rules of its own, or none.
pub fn less(root: &Path, hidden: &[PathBuf]) -> Vec<Readable> {
    let mut rules = Vec::new();
    collect(root, hidden, &mut rules);
    rules
}

fn collect(path: &Path, hidden: &[PathBuf], rules: &mut Vec<Readable>) {
    if hidden.iter().any(|hidden| path.starts_with(hidden)) {
        return;
    }
    if !hidden.iter().any(|hidden| hidden.starts_with(path)) {
        rules.push(Readable::All(path.to_owned()));
        return;
    }
    rules.push(Readable::Names(path.to_owned()));
    // A folder that cannot be listed has nothing that could be allowed.
    for entry in std::fs::read_dir(path).into_iter().flatten().flatten() {
        if entry.file_type().is_ok_and(|kind| !kind.is_symlink()) {
            collect(&entry.path(), hidden, rules);
        }
    }
}

/// The folder that belongs to a program: the one in which its file lies. Of a file that lies about in a folder of many other
/// things (the home folder, the one for temporary files, the root, or a folder above these) it is the file alone.
///
/// The file is not looked up through links: a hand-in's link leads out of its folder, and what it leads to is not the hand-in's.
pub fn own(file: &Path) -> Option<PathBuf> {
    let parent = file.parent()?.canonicalize().ok()?;
    if is_shared(&parent) {
        let name = file.file_name()?;
        let itself = parent.join(name);
        return itself
            .symlink_metadata()
            .is_ok_and(|kind| !kind.is_symlink())
            .then_some(itself);
    }
    Some(parent)
}

/// Whether a folder is one of many things: the home folder, the one for temporary files, or one above these.
fn is_shared(folder: &Path) -> bool {
    let shared = [
        std::env::home_dir(),
        Some(std::env::temp_dir()),
        Some(PathBuf::from("/dev/shm")),
        Some(PathBuf::from("/var/tmp")),
    ];
    let shared = shared.into_iter().flatten();
    let shared = shared.map(|path| path.canonicalize().unwrap_or(path));
    shared.into_iter().any(|path| path.starts_with(folder))
}
