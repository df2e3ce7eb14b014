//! A hand-in that is a folder.

use super::{Basket, packed};
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

/// The packed hand-in in a folder that holds nothing else.
pub fn only_packed(folder: &Path) -> io::Result<Option<PathBuf>> {
    let mut only = None;
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let is_packed = entry.file_type()?.is_file()
            && entry
                .file_name()
                .to_str()
                .is_some_and(|name| packed(name).is_some());
        if !is_packed || only.is_some() {
            return Ok(None);
        }
        only = Some(entry.path());
    }
    Ok(only)
}

/// Opens a file, unless something else has taken its place: a link, which is not followed, or a pipe, which is not waited for.
fn open(path: &Path) -> io::Result<Option<File>> {
    #[cfg(unix)]
    let file = {
        use rustix::fs::{Mode, OFlags, open};
        let flags = OFlags::RDONLY | OFlags::NOFOLLOW | OFlags::NONBLOCK | OFlags::CLOEXEC;
        match open(path, flags, Mode::empty()) {
            Err(rustix::io::Errno::LOOP) => return Ok(None),
            opened => File::from(opened?),
        }
    };
    #[cfg(not(unix))]
    let file = File::open(path)?;
    Ok(file.metadata()?.is_file().then_some(file))
}

/// Takes what is in a folder, and in those below it; `above` is its path in the hand-in.
pub fn collect(folder: &Path, above: &str, basket: &mut Basket) -> io::Result<()> {
    let mut entries = fs::read_dir(folder)?.collect::<io::Result<Vec<_>>>()?;
    entries.sort_by_key(fs::DirEntry::file_name);
    for entry in entries {
        let name = entry.file_name();
        let bytes = name.as_encoded_bytes();
        let path = [above.as_bytes(), bytes].concat();
        let kind = entry.file_type()?;
        if kind.is_dir() {
            // A name inside it that would be wanted: whether the folder itself is one that is looked through.
            let inside = [&path, &b"/raybook.toml"[..]].concat();
            if let Some(inside) = basket.wants(&inside)? {
                let below = inside.strip_suffix("raybook.toml").unwrap_or_default();
                collect(&entry.path(), below, basket)?;
            }
        } else if kind.is_file() {
            if let Some(name) = basket.wants(&path)? {
                match open(&entry.path())? {
                    Some(file) => basket.put(name, file)?,
                    None => basket.leave_out(&path, "no file any more"),
                }
            }
        } else {
            basket.leave_out(
                &path,
                if kind.is_symlink() {
                    "a link"
                } else {
                    "a pipe, a socket or a device"
                },
            );
        }
    }
    Ok(())
}
