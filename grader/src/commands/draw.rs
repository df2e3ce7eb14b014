//! `raybook draw`: a chapter's pictures, drawn by the student's own functions.

use super::Done;
use raybook_grader::{drawn, student};
use raybook_workbook::curriculum::CHAPTERS;
use std::ffi::OsString;
use std::path::Path;
use std::process::Command;

/// Draws a chapter's pictures with the workbook's functions; the first time, this compiles the chapters.
#[derive(clap::Args)]
pub struct Draw {
    /// The chapter (3, ch03, sphere)
    chapter: String,
    /// The chapter's own options: --width 320; `raybook draw ch03 --help` lists them
    #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
    options: Vec<OsString>,
}

impl Draw {
    /// Compiles, and draws; false if a function that the chapter needs is not written yet.
    pub fn run(&self) -> Done {
        /// The chapter's exit code where a function is not written.
        const UNWRITTEN: i32 = 1;
        let chapter = CHAPTERS
            .iter()
            .find(|chapter| chapter.answers_to(&self.chapter));
        let chapter = chapter.ok_or_else(|| {
            let names: Vec<_> = CHAPTERS.iter().map(|chapter| chapter.name).collect();
            format!(
                "{}: no chapter is called so; there are {}",
                self.chapter,
                names.join(", ")
            )
        })?;
        let workbook = student::workbook(Path::new("."))?;
        let program = drawn::program(&workbook, chapter)?;
        let status = Command::new(&program.file)
            .args(&self.options)
            .current_dir(&program.folder)
            .status()?;
        match status.code() {
            Some(0) => Ok(true),
            Some(UNWRITTEN) => Ok(false),
            _ => Err(format!("{} was not drawn: {status}", chapter.name).into()),
        }
    }
}
