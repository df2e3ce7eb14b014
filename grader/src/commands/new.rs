//! `raybook new`: a student's folder.

use super::{Done, by_cargo};
use raybook_chapters::kit::say::say;
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_grader::language::Language;
use raybook_grader::{cases, starter};
use std::path::PathBuf;

/// Makes a workbook folder.
#[derive(clap::Args)]
pub struct New {
    /// The folder to make
    folder: PathBuf,
    /// The language in which you write: python, cpp or rust
    #[arg(long, default_value = "rust", value_parser = Language::named)]
    language: Language,
}

impl New {
    /// Makes it, and says what to do next.
    pub fn run(&self) -> Done {
        starter::create(&self.folder, self.language)?;
        let folder = Untrusted::from(self.folder.as_path());
        say(format!(
            "made {}, with {} exercises:\n",
            folder,
            cases::all().len()
        ));
        say(starter::course_map().trim_end());
        let compiles = match self.language {
            Language::Rust => "        (the first time, this compiles for a minute)",
            Language::Cpp => "        (the first time, this compiles for half a minute)",
            Language::Python => "",
        };
        let folder = folder.shell();
        say(match by_cargo() {
            Some(run) => format!(
                "\nNext:  {run} check {folder}{compiles}\n       or, once for all: cargo install --path grader; then cd {folder} and raybook check"
            ),
            None => format!("\nNext:  cd {folder}\n       raybook check{compiles}"),
        });
        Ok(true)
    }
}
