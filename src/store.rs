//! Files: what is read is a file of bounded size and nothing else, and what is written appears whole or not at all.
//!
//! A file is written under a random name beside the place where it belongs. It is opened so that nothing that is there already
//! is touched and no link is followed, and it lies on the disk before it gets its name.

use crate::memory::{BUDGET, gigabytes};
use std::fs::{self, File, FileType, Metadata, OpenOptions};
use std::hash::{BuildHasher, RandomState};
use std::io::{self, ErrorKind, Read, Write};
use std::path::{Path, PathBuf};
use std::thread;

/// Why a file or a folder cannot be read or written; it is named.
#[derive(Debug, thiserror::Error)]
#[error("{}: cannot {doing}: {reason}", path.display())]
pub struct StoreError {
    /// The file or the folder.
    pub path: PathBuf,
    /// "read this file", "write this file", "make this folder" or the like.
    pub doing: &'static str,
    /// The system's answer, or what is there instead of a file.
    pub reason: io::Error,
}

impl StoreError {
    /// The error of doing something with a file or a folder, from the reason.
    pub fn of(path: &Path, doing: &'static str) -> impl FnOnce(io::Error) -> Self {
        move |reason| Self {
            path: path.into(),
            doing,
            reason,
        }
    }
}

/// The bytes of a file, at most [`BUDGET`]; of the file that a link leads to, where it is a link.
///
/// # Errors
/// If it cannot be read, is a folder, a named pipe, a device or a socket, or is larger.
pub fn read(path: &Path) -> Result<Vec<u8>, StoreError> {
    read_file(path).map_err(StoreError::of(path, "read this file"))
}

/// The text of a file, as [`read`] reads it.
///
/// # Errors
/// Those of [`read`]; and if it is not UTF-8.
pub fn read_text(path: &Path) -> Result<String, StoreError> {
    let not_text = |error| io::Error::new(ErrorKind::InvalidData, error);
    String::from_utf8(read(path)?)
        .map_err(not_text)
        .map_err(StoreError::of(path, "read this file"))
}

/// Opens a file, or the one that a link leads to, to read it.
///
/// # Errors
/// If it cannot be read, or is a folder, a named pipe, a device or a socket.
pub fn open(path: &Path) -> Result<File, StoreError> {
    open_file(path).map_err(StoreError::of(path, "read this file"))
}

fn open_file(path: &Path) -> io::Result<File> {
    // Before it is opened: a named pipe would wait for somebody who writes, and opening a device may do something.
    expect_file(&fs::metadata(path)?)?;
    File::open(path)
}

fn read_file(path: &Path) -> io::Result<Vec<u8>> {
    let file = open_file(path)?;
    let length = file.metadata()?.len();
    let mut bytes = Vec::new();
    if length <= BUDGET {
        bytes.try_reserve_exact(length as usize)?;
        // It may have grown since, or be one of the system's, which have no length.
        file.take(BUDGET + 1).read_to_end(&mut bytes)?;
    }
    match length.max(bytes.len() as u64) {
        ..=BUDGET => Ok(bytes),
        length => Err(io::Error::new(
            ErrorKind::FileTooLarge,
            format!(
                "it has {}, and at most {} are read; make it smaller",
                gigabytes(length),
                gigabytes(BUDGET)
            ),
        )),
    }
}

fn expect_file(there: &Metadata) -> io::Result<()> {
    if there.is_file() {
        return Ok(());
    }
    let what = format!("it is {}, and not a file", kind(there.file_type()));
    Err(io::Error::new(ErrorKind::InvalidInput, what))
}

/// What is no file.
fn kind(of: FileType) -> &'static str {
    #[cfg(unix)]
    {
        use std::os::unix::fs::FileTypeExt;
        if of.is_fifo() {
            return "a named pipe (FIFO)";
        }
        if of.is_socket() {
            return "a socket";
        }
        if of.is_char_device() || of.is_block_device() {
            return "a device";
        }
    }
    if of.is_dir() {
        "a folder"
    } else {
        "something else"
    }
}

/// Writes a file so that it appears whole or not at all, in a folder that is made if need be. A file or a link that has this
/// name is replaced.
///
/// # Errors
/// If the folder cannot be made, the file cannot be written, or the name is that of a folder, a named pipe, a device or a socket.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), StoreError> {
    write_file(path, bytes).map_err(StoreError::of(path, "write this file"))
}

fn write_file(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let folder = folder_of(path);
    make_folders(folder)?;
    if let Ok(there) = fs::symlink_metadata(path)
        && !there.is_symlink()
    {
        expect_file(&there)?;
    }
    let (partial, file) = partial(folder, |partial| {
        OpenOptions::new()
            .write(true)
            .create_new(true)
            .open(partial)
    })?;
    let written = fill(file, bytes).and_then(|()| fs::rename(&partial, path));
    if written.is_err() {
        // The first error is the one worth reporting.
        let _ = fs::remove_file(&partial);
    }
    written?;
    remember_names(folder);
    Ok(())
}

/// Makes a folder with these files in it, whose paths are relative to it.
///
/// A new folder appears whole or not at all. In a folder that is there already, and empty, the files and folders appear one by
/// one in the order of `files`, so that the last one says that all are there; if that was interrupted, this completes it.
///
/// # Errors
/// If there is something in the folder, there is a file of this name, or something cannot be written.
pub fn new_folder(folder: &Path, files: &[(PathBuf, Vec<u8>)]) -> Result<(), StoreError> {
    let made = match fs::metadata(folder) {
        Ok(there) if there.is_dir() => fill_folder(folder, files),
        Ok(there) => Err(io::Error::new(
            ErrorKind::AlreadyExists,
            format!(
                "there is {} of this name; choose a new one",
                if there.is_file() {
                    "a file"
                } else {
                    kind(there.file_type())
                }
            ),
        )),
        Err(_) => place_folder(folder, files),
    };
    made.map_err(StoreError::of(folder, "make this folder"))
}

fn place_folder(folder: &Path, files: &[(PathBuf, Vec<u8>)]) -> io::Result<()> {
    let parent = folder_of(folder);
    make_folders(parent)?;
    let (partial, ()) = partial(parent, |partial| fs::create_dir(partial))?;
    let placed = write_all(&partial, files).and_then(|()| fs::rename(&partial, folder));
    if placed.is_err() {
        let _ = fs::remove_dir_all(&partial);
    }
    placed.map_err(|error| match error.kind() {
        // Somebody else was faster.
        ErrorKind::DirectoryNotEmpty | ErrorKind::AlreadyExists => not_empty(),
        _ => error,
    })?;
    remember_names(parent);
    Ok(())
}

/// What an empty folder holds while it is being filled: as long as it is there, everything beside it is from here and whole.
const UNFINISHED: &str = ".raybook-new.partial";

/// The folder itself stays: it may be somebody's present one, or another disk.
fn fill_folder(folder: &Path, files: &[(PathBuf, Vec<u8>)]) -> io::Result<()> {
    let partial = folder.join(UNFINISHED);
    if partial.is_dir() {
        fs::remove_dir_all(&partial)?;
    } else if folder.read_dir()?.next().is_some() {
        return Err(not_empty());
    }
    fs::create_dir(&partial)?;
    if let Err(error) = write_all(&partial, files) {
        let _ = fs::remove_dir_all(&partial);
        return Err(error);
    }
    for (path, _) in files {
        let Some(top) = path.components().next() else {
            continue;
        };
        let (from, to) = (partial.join(top), folder.join(top));
        if from.exists() && !to.exists() {
            fs::rename(from, to)?;
        }
    }
    remember_names(folder);
    fs::remove_dir_all(&partial)
}

fn not_empty() -> io::Error {
    io::Error::new(
        ErrorKind::DirectoryNotEmpty,
        "it is not empty; choose a new name",
    )
}

/// How many files wait for the disk at the same time, which takes them together.
const AT_ONCE: usize = 16;

fn write_all(folder: &Path, files: &[(PathBuf, Vec<u8>)]) -> io::Result<()> {
    let write = |(path, bytes): &(PathBuf, Vec<u8>)| {
        let path = folder.join(path);
        make_folders(folder_of(&path))?;
        fill(File::create_new(path)?, bytes)
    };
    let write_each = |part: &[(PathBuf, Vec<u8>)]| part.iter().try_for_each(write);
    let part = files.len().div_ceil(AT_ONCE).max(1);
    thread::scope(|scope| {
        let write_part =
            |part| thread::Builder::new().spawn_scoped(scope, move || write_each(part));
        let writers: io::Result<Vec<_>> = files.chunks(part).map(write_part).collect();
        writers?.into_iter().try_for_each(|writer| {
            let crashed = |_| Err(io::Error::other("a thread of this command crashed"));
            writer.join().unwrap_or_else(crashed)
        })
    })
}

fn fill(mut file: File, bytes: &[u8]) -> io::Result<()> {
    file.write_all(bytes)?;
    file.sync_all()
}

/// Makes something in a folder under a random name that is still free; returns its path.
fn partial<T>(folder: &Path, make: impl Fn(&Path) -> io::Result<T>) -> io::Result<(PathBuf, T)> {
    loop {
        let number = RandomState::new().hash_one(std::process::id());
        let path = folder.join(format!(".raybook-{number:016x}.partial"));
        match make(&path) {
            Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
            made => return Ok((path, made?)),
        }
    }
}

fn make_folders(folder: &Path) -> io::Result<()> {
    fs::create_dir_all(folder).map_err(|error| {
        io::Error::new(
            error.kind(),
            format!("the folder {} cannot be made: {error}", folder.display()),
        )
    })
}

/// The folder in which a file or a folder is.
fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    }
}

/// Sees to it that new names in a folder outlast a power cut, where the system can; the files themselves already do.
fn remember_names(folder: &Path) {
    #[cfg(unix)]
    let _ = File::open(folder).and_then(|folder| folder.sync_all());
    #[cfg(not(unix))]
    let _ = folder;
}
