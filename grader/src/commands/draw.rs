//! `raybook draw`: a chapter's pictures, drawn by the student's own functions.

use super::{Done, chapter, draw_asked};
use raybook_grader::recipe::Recipe;
use raybook_grader::{own_chapters, student};
use std::ffi::OsString;
use std::path::Path;
use std::process::Command;

/// Draws a chapter's pictures with the workbook's functions; in Rust the first time compiles the chapters. In other languages the
/// program is asked for each pixel of what the chapter's exercises see.
#[derive(clap::Args)]
pub struct Draw {
    /// The chapter (3, ch03, sphere)
    chapter: String,
    /// The chapter's own options, in Rust: --width 320; `raybook draw ch03 --help` lists them
    #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
    options: Vec<OsString>,
}

impl Draw {
    /// Compiles, and draws; false if a function that the chapter needs is not written yet.
    pub fn run(&self) -> Done {
        /// The chapter's exit code where a function is not written.
        const UNWRITTEN: i32 = 1;
        let chapter = chapter(&self.chapter)?;
        let workbook = student::workbook(Path::new("."))?;
        let recipe = Recipe::read(&workbook)?;
        if recipe != Recipe::Rust {
            if !self.options.is_empty() {
                return Err("a chapter has options where its workbook is in Rust; here its functions are asked for their pictures, which have sizes of their own".into());
            }
            return draw_asked::run(&workbook, chapter);
        }
        let program = own_chapters::program(&workbook, chapter)?;
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
