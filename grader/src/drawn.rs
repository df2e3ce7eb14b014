//! The chapters on a student's own code: their package is laid into the workbook when it is asked for, and compiled with the
//! student's library.

use crate::converse::Program;
use crate::library;
use crate::manifest;
use crate::starter::{self, StarterError, StarterFile, copies, stub};
use crate::student::{StudentError, build_binary};
use raybook::image::file;
use raybook_workbook::curriculum::Chapter;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs, io};

/// Where the chapters' package is in the workbook: beside what else is not the student's.
const FOLDER: &str = ".raybook/chapters";

/// Why a chapter cannot be drawn.
#[derive(Debug, thiserror::Error)]
pub enum DrawError {
    /// The chapters cannot be laid into the workbook.
    #[error(transparent)]
    Lay(#[from] StarterError),
    /// They cannot be compiled.
    #[error(transparent)]
    Build(#[from] StudentError),
}

/// Compiles a chapter's program with the workbook's library.
///
/// # Errors
/// If the chapters cannot be laid into the workbook, or do not compile with it.
pub fn program(workbook: &Path, chapter: &Chapter) -> Result<Program, DrawError> {
    lay(workbook)?;
    let mut cargo = Command::new("cargo");
    if env::var_os("CARGO_TARGET_DIR").is_none() {
        cargo.env("CARGO_TARGET_DIR", workbook.join("target"));
    }
    let program = build_binary(
        &mut cargo,
        &workbook.join(FOLDER),
        chapter.name,
        &["--release"],
    )?;
    Ok(Program {
        folder: workbook.to_owned(),
        ..program
    })
}

/// The files of the chapters' package, with their paths in the workbook.
///
/// # Errors
/// If an anchor in the course is wrong.
pub fn files() -> Result<Vec<StarterFile>, StarterError> {
    let mut files = copies(FOLDER, library::chapters(), &stub)?;
    files.push((
        Path::new(FOLDER).join(library::MANIFEST),
        manifest::chapters().into_bytes(),
    ));
    Ok(files)
}

/// Makes the package in the workbook that of this command. What is the same already is not written, so that it is not compiled
/// again; what an older command left there is removed.
fn lay(workbook: &Path) -> Result<(), StarterError> {
    let mut wanted = Vec::new();
    let mut changed = false;
    for (path, bytes) in files()? {
        let path = workbook.join(path);
        if fs::read(&path).ok().as_ref() != Some(&bytes) {
            write(&path, &bytes)?;
            changed = true;
        }
        wanted.push(path);
    }
    let lock = workbook.join(FOLDER).join("Cargo.lock");
    if changed {
        // Cargo strikes out of it what is not used.
        write(&lock, starter::LOCK.as_bytes())?;
    }
    wanted.push(lock);
    for path in files_below(&workbook.join(FOLDER)) {
        if !wanted.contains(&path) {
            fs::remove_file(&path).map_err(|source| StarterError::Write { path, source })?;
        }
    }
    Ok(())
}

fn write(path: &Path, bytes: &[u8]) -> Result<(), StarterError> {
    let failed = |source: io::Error| StarterError::Write {
        path: path.to_owned(),
        source,
    };
    file::write_whole(path, bytes).map_err(failed)
}

/// All files in a folder and in those below it; none where it cannot be read.
fn files_below(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let below = entries.map(|entry| entry.path()).map(|path| {
        if path.is_dir() {
            files_below(&path)
        } else {
            vec![path]
        }
    });
    below.flatten().collect()
}
