//! Reading and writing files: only regular files of bounded size are read, and a written file appears whole or not at all.
//!
//! A file is first written under a random name in its folder. It is opened in a mode that does not touch existing files and does
//! not follow links, and all bytes are on the disk before the file gets its final name.
//!
//! ```
//! use raybook::store;
//! use std::path::Path;
//!
//! // An error names the file, and what was to be done with it.
//! let error = store::read(Path::new("no such file")).expect_err("there is no such file");
//! assert!(error.to_string().starts_with("no such file: cannot read this file: "));
//! ```

use crate::memory::{BUDGET, gigabytes};
use std::fs::{self, File, FileType, Metadata, OpenOptions};
use std::hash::{BuildHasher, RandomState};
use std::io::{self, ErrorKind, Read, Write};
use std::path::{Path, PathBuf};
use std::thread;

/// Why a file or a folder cannot be read or written; the error names it.
#[derive(Debug, thiserror::Error)]
#[error("{}: cannot {doing}: {reason}", path.display())]
pub struct StoreError {
    /// The file or the folder.
    pub path: PathBuf,
    /// "read this file", "write this file", "make this folder" or the like.
    pub doing: &'static str,
    /// The system's error, or what was found instead of a file.
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

/// The bytes of a file of at most [`BUDGET`] bytes. Links are followed.
///
/// # Errors
/// If the file cannot be read, is a folder, a named pipe, a device or a socket, or is larger than the budget.
pub fn read(path: &Path) -> Result<Vec<u8>, StoreError> {
    read_file(path).map_err(StoreError::of(path, "read this file"))
}

/// The text of a file, as [`read`] reads it.
///
/// # Errors
/// Those of [`read`]; and if the file is not UTF-8.
pub fn read_text(path: &Path) -> Result<String, StoreError> {
    let not_text = |error| io::Error::new(ErrorKind::InvalidData, error);
    String::from_utf8(read(path)?)
        .map_err(not_text)
        .map_err(StoreError::of(path, "read this file"))
}

/// Opens a file for reading. Links are followed.
///
/// # Errors
/// If the file cannot be read, or is a folder, a named pipe, a device or a socket.
pub fn open(path: &Path) -> Result<File, StoreError> {
    open_file(path).map_err(StoreError::of(path, "read this file"))
}

fn open_file(path: &Path) -> io::Result<File> {
    // Checked before opening: opening a named pipe would wait for a writer, and opening a device may have an effect.
    expect_file(&fs::metadata(path)?)?;
    File::open(path)
}

fn read_file(path: &Path) -> io::Result<Vec<u8>> {
    let file = open_file(path)?;
    let length = file.metadata()?.len();
    let mut bytes = Vec::new();
    if length <= BUDGET {
        bytes.try_reserve_exact(length as usize)?;
        // The file may have grown since, or be a file of the system, whose length is 0.
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
    let what = format!("it is {}", kind(there.file_type()));
    Err(io::Error::new(ErrorKind::InvalidInput, what))
}

/// The kind of something that is not a regular file, for error messages.
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
        "neither a file nor a folder"
    }
}

/// Writes a file so that it appears whole or not at all. Its folder is made if it does not exist. A file or a link of the same
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
        // Only the first error is reported.
        let _ = fs::remove_file(&partial);
    }
    written?;
    remember_names(folder);
    Ok(())
}

/// Makes a folder with these files in it; the paths of the files are relative to the folder.
///
/// A new folder appears whole or not at all. In an existing empty folder, the files and folders appear one by one in the order of
/// `files`, so that the last one shows that all are there. If this was interrupted, another call completes it.
///
/// # Errors
/// If the folder is not empty, there is a file of this name, or something cannot be written.
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
        // Another program has made a folder of this name in the meantime.
        ErrorKind::DirectoryNotEmpty | ErrorKind::AlreadyExists => not_empty(),
        _ => error,
    })?;
    remember_names(parent);
    Ok(())
}

/// The name of a subfolder that is in a folder while the folder is being filled. As long as it exists, everything beside it was
/// written by [`new_folder`], and is complete.
const UNFINISHED: &str = ".raybook-new.partial";

/// Fills an existing empty folder. The folder itself is kept: it may be the current folder of a program, or another disk.
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

/// Number of files that are written at the same time, because a disk syncs several files together.
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

/// Calls `make` with a path in a folder, under a random name that is still free; returns the path and the result.
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

/// The parent folder of a path.
fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    }
}

/// Makes new names in a folder survive a power cut, if the system can do this; the contents of the files already do.
fn remember_names(folder: &Path) {
    #[cfg(unix)]
    let _ = File::open(folder).and_then(|folder| folder.sync_all());
    #[cfg(not(unix))]
    let _ = folder;
}
