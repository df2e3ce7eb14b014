//! Which answer program a command asks, and how long it waits.

use raybook_chapters::kit::say::complain;
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_grader::command_line;
use raybook_grader::converse::{Limits, Program};
use raybook_grader::sandbox::Sandbox;
use raybook_grader::student;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// The options of every command that asks an answer program.
#[derive(clap::Args)]
pub struct Asking {
    /// Ask this program: any that answers a line per line, or a command ("python3 answer.py"); or a workbook's folder, to build its program
    #[arg(long, value_name = "FILE|COMMAND|FOLDER")]
    pub program: Option<PathBuf>,
    /// How long to wait for one answer, in seconds; all of an exercise may take 150 times as long, and a check 900 times
    #[arg(long, default_value = "2.0", value_parser = super::seconds)]
    time_limit: f32,
    /// Run --program with all your rights, outside of the sandbox: it can read and change what you can
    #[arg(long, requires = "program")]
    trust: bool,
}

impl Asking {
    /// What it may use for one answer.
    pub fn limits(&self) -> Limits {
        Limits::of(Duration::from_secs_f32(self.time_limit))
    }

    /// These options as they are typed in a shell, each word after a space.
    pub fn again(&self) -> String {
        let program = self.program.as_ref();
        let program =
            program.map(|file| format!(" --program {}", Untrusted::from(file.as_path()).shell()));
        let unusual = self.limits() != Limits::default();
        let time = unusual.then(|| format!(" --time-limit {}", self.time_limit));
        let trust = self.trust.then(|| " --trust".to_owned());
        [program, time, trust].into_iter().flatten().collect()
    }

    /// The program to ask, and the folder of one's own workbook: that of `--program`, a stranger's, in a sandbox in which nothing
    /// that is `hidden` can be read; or of the workbook at `from`, one's own.
    ///
    /// # Errors
    /// If there is no such program, it cannot be built, or this system cannot contain it.
    pub fn program(
        &self,
        from: &Path,
        hidden: Vec<PathBuf>,
    ) -> Result<(Program, Option<PathBuf>), Box<dyn Error>> {
        let Some(path) = &self.program else {
            let workbook = student::workbook(from)?;
            return Ok((student::build(&workbook)?, Some(workbook)));
        };
        let sandbox = if self.trust {
            // To standard error: standard output may be JSON.
            let file = Untrusted::from(path.as_path());
            complain(format!(
                "{file}: runs with all your rights, as --trust says"
            ));
            None
        } else {
            Some(Sandbox::new(hidden)?.with_processor_time(self.limits().check.time))
        };
        match (path.is_dir(), sandbox) {
            (true, None) => {
                let workbook = student::workbook(path)?;
                Ok((student::build(&workbook)?, Some(workbook)))
            }
            (true, Some(sandbox)) => {
                let workbook = student::workbook(path)?;
                Ok((student::build_in(&sandbox, &workbook)?, None))
            }
            (false, sandbox) => Ok((command_line::program(path, sandbox)?, None)),
        }
    }
}
