//! Which answer program a command asks, and how long it waits.

use raybook::grade::converse::{Limits, Program};
use raybook::grade::student;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// The options of every command that asks an answer program.
#[derive(clap::Args)]
pub struct Asking {
    /// Ask this program: any that answers a line per line; or a workbook's folder, to build its program
    #[arg(long, value_name = "FILE|FOLDER")]
    pub program: Option<PathBuf>,
    /// How long to wait for one answer, in seconds
    #[arg(long, default_value_t = 2.0, value_parser = super::seconds)]
    time_limit: f32,
}

impl Asking {
    /// The program that was named, or else that of the workbook around a folder; and the workbook it is built from, if it is.
    ///
    /// # Errors
    /// If there is no workbook, or its program cannot be built.
    pub fn program_or(&self, around: &Path) -> Result<(Program, Option<PathBuf>), Box<dyn Error>> {
        let named = self.program.as_deref().unwrap_or(around);
        if self.program.is_none() || named.is_dir() {
            let workbook = student::workbook(named)?;
            return Ok((student::build(&workbook)?, Some(workbook)));
        }
        let program = Program {
            file: std::path::absolute(named)?,
            arguments: Vec::new(),
            folder: PathBuf::new(),
        };
        Ok((program, None))
    }

    /// What it may use for one answer.
    pub fn limits(&self) -> Limits {
        Limits {
            time: Duration::from_secs_f32(self.time_limit),
            ..Limits::default()
        }
    }

    /// These options as they are typed, each word after a space.
    pub fn again(&self) -> String {
        let program = self.program.as_ref();
        let program = program.map(|file| format!(" --program {:?}", file.display().to_string()));
        let unusual = self.limits() != Limits::default();
        let time = unusual.then(|| format!(" --time-limit {}", self.time_limit));
        [program, time].into_iter().flatten().collect()
    }
}
