//! Making and building student's folders.

use super::executable;
use raybook_grader::converse::Program;
use raybook_grader::starter::{StarterFile, files};
use raybook_workbook::anchor::Anchored;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// The folder in which all starters of the tests compile: their dependencies are compiled once.
pub fn target() -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join("starter")
}

/// Only one starter is written and built at a time.
static FOLDER: Mutex<()> = Mutex::new(());

/// The folder of a starter; nobody else has it as long as this is held.
pub struct Written {
    pub folder: PathBuf,
    _alone: MutexGuard<'static, ()>,
}

/// Writes a starter whose anchored functions are rewritten so.
///
/// The folder is always the same.
pub fn write(rewrite: &dyn Fn(&Anchored<'_>) -> Option<String>) -> Written {
    // Another test's failure says nothing about the folder.
    let alone = FOLDER.lock().unwrap_or_else(PoisonError::into_inner);
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("my-rays");
    lay(
        &folder,
        files(rewrite).expect("the library's anchors are right"),
    );
    Written {
        folder,
        _alone: alone,
    }
}

/// Lays a starter's files into a folder. One that stays the same is not written, so that the compiler goes on from the build before:
/// seconds instead of a minute.
pub fn lay(folder: &Path, files: Vec<StarterFile>) {
    for (path, bytes) in files {
        let path = folder.join(path);
        if fs::read(&path).is_ok_and(|there| there == bytes) {
            continue;
        }
        fs::create_dir_all(path.parent().expect("a file is in a folder"))
            .expect("the folder can be made");
        fs::write(path, bytes).expect("the file can be written");
    }
}

/// Writes a starter whose anchored functions are rewritten so, builds its answer program, and keeps that in `keep`.
pub fn build(keep: &Path, rewrite: &dyn Fn(&Anchored<'_>) -> Option<String>) -> Program {
    let written = write(rewrite);
    let output = Command::new(env!("CARGO"))
        .args(["build", "--quiet", "--offline", "--bin", "answer"])
        .current_dir(&written.folder)
        .env("CARGO_TARGET_DIR", target())
        .output()
        .expect("cargo can be run");
    assert!(
        output.status.success(),
        "the starter compiles: {}",
        String::from_utf8_lossy(&output.stderr)
    );
    assert!(
        output.stderr.is_empty(),
        "without a warning: {}",
        String::from_utf8_lossy(&output.stderr)
    );
    let (built, kept) = (target().join("debug/answer"), keep.join("answer"));
    executable::copy(&built, &kept);
    Program {
        file: kept,
        arguments: Vec::new(),
        folder: PathBuf::new(),
        sandbox: None,
    }
}
