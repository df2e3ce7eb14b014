//! Which answer program a command asks, and how long it waits.

use raybook_grader::converse::{Limits, Program};
use raybook_grader::student;
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

/// The program at a path: a file is one, and of a folder the workbook's is built, which is returned too.
///
/// # Errors
/// If the folder is in no workbook, or its program cannot be built.
pub fn program_at(path: &Path) -> Result<(Program, Option<PathBuf>), Box<dyn Error>> {
    if path.is_dir() {
        let workbook = student::workbook(path)?;
        return Ok((student::build(&workbook)?, Some(workbook)));
    }
    let program = Program {
        file: std::path::absolute(path)?,
        arguments: Vec::new(),
        folder: PathBuf::new(),
    };
    Ok((program, None))
}
