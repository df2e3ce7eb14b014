//! The chapters on a student's own code: their package is laid into the workbook when it is asked for, and compiled with the
//! student's library.

use crate::converse::Program;
use crate::library;
use crate::lock::Lock;
use crate::manifest;
use crate::progress::KEPT;
use crate::starter::{self, StarterError, StarterFile, copies, stub};
use crate::student::{StudentError, build_binary};
use raybook::store::{self, StoreError};
use raybook_workbook::curriculum::Chapter;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

/// Where the chapters' package is in the workbook: beside what else is not the student's.
const FOLDER: &str = ".raybook/chapters";

/// Where the example is that chapter 19 draws: beside the chapters, as in the course.
const EXAMPLE: &str = ".raybook/examples/many_balls.rs";

/// Why a chapter cannot be drawn.
#[derive(Debug, thiserror::Error)]
pub enum DrawError {
    /// The chapters cannot be laid into the workbook.
    #[error(transparent)]
    Lay(#[from] StarterError),
    /// One of their files cannot be written or removed there.
    #[error(transparent)]
    Store(#[from] StoreError),
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

/// The files of the chapters' package and of the example, with their paths in the workbook.
///
/// # Errors
/// If an anchor in the course is wrong.
pub fn files() -> Result<Vec<StarterFile>, StarterError> {
    let mut files = copies(FOLDER, library::chapters(), &stub)?;
    for (package, manifest) in [("", manifest::chapters()), ("scenes", manifest::scenes())] {
        let path = Path::new(FOLDER).join(package).join(library::MANIFEST);
        files.push((path, manifest.into_bytes()));
    }
    files.push((EXAMPLE.into(), library::MANY_BALLS.as_bytes().to_vec()));
    Ok(files)
}

/// Makes the package in the workbook that of this command. What is the same already is not written, so that it is not compiled
/// again; what an older command left there is removed.
fn lay(workbook: &Path) -> Result<(), DrawError> {
    let _lock = Lock::on(&workbook.join(KEPT))?;
    let mut wanted = Vec::new();
    let mut changed = false;
    for (path, bytes) in files()? {
        let path = workbook.join(path);
        if store::read(&path).ok().as_ref() != Some(&bytes) {
            store::write(&path, &bytes)?;
            changed = true;
        }
        wanted.push(path);
    }
    let lock = workbook.join(FOLDER).join("Cargo.lock");
    if changed {
        // Cargo strikes out of it what is not used.
        store::write(&lock, starter::LOCK.as_bytes())?;
    }
    wanted.push(lock);
    for path in files_below(&workbook.join(FOLDER)) {
        if !wanted.contains(&path) {
            fs::remove_file(&path).map_err(StoreError::of(&path, "remove this file"))?;
        }
    }
    Ok(())
}

/// All files in a folder and in those below it, but not in those that a link leads to; none where it cannot be read.
fn files_below(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let below = entries.map(|entry| match entry.file_type() {
        Ok(kind) if kind.is_dir() => files_below(&entry.path()),
        _ => vec![entry.path()],
    });
    below.flatten().collect()
}
