//! A program that answers: how it is started, and why it is not.

use crate::sandbox::Sandbox;
use crate::starter::MARKER;
use raybook_chapters::kit::untrusted::Untrusted;
use std::ffi::OsString;
use std::io;
use std::path::PathBuf;

/// How to start an answer program.
#[derive(Clone, Debug)]
pub struct Program {
    /// The file.
    pub file: PathBuf,
    /// Its arguments.
    pub arguments: Vec<OsString>,
    /// The folder it runs in; the present one if empty.
    pub folder: PathBuf,
    /// The sandbox of a stranger's program; one's own runs with all of one's rights.
    pub sandbox: Option<Sandbox>,
}

/// Why a program does not start, and what to do about it.
pub(super) fn cannot_start(program: &Program, error: &io::Error) -> io::Error {
    let file = Untrusted::from(program.file.as_path());
    let advice = match error.kind() {
        io::ErrorKind::PermissionDenied => {
            format!("; is it executable? chmod +x {}", file.shell())
        }
        io::ErrorKind::NotFound if program.file.exists() => {
            "; the file is there: is the program that its first line names after `#!`?".to_owned()
        }
        io::ErrorKind::NotFound if program.file.components().count() == 1 => {
            format!("; is it installed? {MARKER} says in its line `run` what is started")
        }
        _ => String::new(),
    };
    io::Error::new(
        error.kind(),
        format!("{file}: cannot be run: {error}{advice}"),
    )
}
