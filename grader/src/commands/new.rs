//! `raybook new`: a student's folder.

use super::Done;
use raybook_chapters::kit::say::say;
use raybook_grader::{cases, starter};
use std::path::PathBuf;

/// Makes a workbook folder.
#[derive(clap::Args)]
pub struct New {
    /// The folder to make
    folder: PathBuf,
}

impl New {
    /// Makes it, and says what to do next.
    pub fn run(&self) -> Done {
        starter::create(&self.folder)?;
        say(format!(
            "made {}, with {} exercises:\n",
            self.folder.display(),
            cases::all().len()
        ));
        say(starter::course_map().trim_end());
        say(format!(
            "\nNext:  cd {}\n       raybook check        (the first time, this compiles for a minute)",
            self.folder.display()
        ));
        Ok(true)
    }
}
