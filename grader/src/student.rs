//! A student's folder, and the answer program that is built from it.

use crate::converse::Program;
use crate::starter::MARKER;
use raybook_chapters::kit::untrusted::Untrusted;
use serde_json::Value;
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// Why there is no answer program.
#[derive(Debug, thiserror::Error)]
pub enum StudentError {
    /// Not a student's folder.
    #[error("{}: this is not a workbook: neither here nor above is there a {MARKER}; `raybook new my-rays` makes one", Untrusted::from(.0.as_path()))]
    NoWorkbook(PathBuf),
    /// Cargo is not there.
    #[error(
        "cannot run cargo, which builds your program: {0}; is Rust installed (https://rustup.rs)?"
    )]
    NoCargo(io::Error),
    /// The compiler refused.
    #[error("your program does not compile; the compiler's message is above")]
    DoesNotCompile,
    /// Cargo built something else.
    #[error("{}: cargo built no program `{program}` here; is everything in workbook/ still there?", Untrusted::from(folder.as_path()))]
    NoProgram {
        /// Where it was to be built.
        folder: PathBuf,
        /// Its name.
        program: String,
    },
}

/// The student's folder: this one, or the nearest above it that is a workbook.
///
/// # Errors
/// If there is none.
pub fn workbook(from: &Path) -> Result<PathBuf, StudentError> {
    let absolute = std::path::absolute(from).unwrap_or_else(|_| from.to_owned());
    let found = absolute
        .ancestors()
        .find(|folder| folder.join(MARKER).is_file());
    found
        .map(Path::to_owned)
        .ok_or(StudentError::NoWorkbook(absolute))
}

/// Builds the answer program. What the compiler has to say goes to standard error.
///
/// # Errors
/// If cargo is missing, or the program does not compile.
pub fn build(folder: &Path) -> Result<Program, StudentError> {
    build_binary(&mut Command::new("cargo"), folder, "answer", &[])
}

/// Builds one of the folder's programs with this cargo and these further options.
///
/// # Errors
/// If cargo is missing, or the program does not compile.
pub fn build_binary(
    cargo: &mut Command,
    folder: &Path,
    binary: &str,
    options: &[&str],
) -> Result<Program, StudentError> {
    let output = cargo
        .args(["build", "--message-format=json-render-diagnostics", "--bin"])
        .arg(binary)
        .args(options)
        .current_dir(folder)
        .stderr(Stdio::inherit())
        .output()
        .map_err(StudentError::NoCargo)?;
    if !output.status.success() {
        return Err(StudentError::DoesNotCompile);
    }
    let executable = |line: &str| {
        let message: Value = serde_json::from_str(line).ok()?;
        let is_asked_for = message["target"]["name"] == binary;
        message["executable"]
            .as_str()
            .filter(|_| is_asked_for)
            .map(PathBuf::from)
    };
    let file = String::from_utf8_lossy(&output.stdout)
        .lines()
        .find_map(executable);
    let file = file.ok_or_else(|| StudentError::NoProgram {
        folder: folder.to_owned(),
        program: binary.to_owned(),
    })?;
    Ok(Program {
        file,
        arguments: Vec::new(),
        folder: folder.to_owned(),
        sandbox: None,
    })
}
