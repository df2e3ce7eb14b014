//! `raybook pack`: what another machine needs to grade.

use super::Done;
use raybook_chapters::kit::say::say;
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_grader::class::pack::Job;
use std::path::{Path, PathBuf};

/// Where to grade.
#[derive(clap::Subcommand)]
pub enum Pack {
    /// Write scripts that grade a class as a job array of Slurm, on folders that all nodes see
    Slurm(Slurm),
}

/// A job array of Slurm.
#[derive(clap::Args)]
pub struct Slurm {
    /// The folder of the scripts, a new one
    folder: PathBuf,
    /// The folder of the hand-ins
    #[arg(long, value_name = "FOLDER")]
    hand_ins: PathBuf,
    /// What counts, and how much
    #[arg(long, value_name = "FILE")]
    course: PathBuf,
    /// The file of the course key
    #[arg(long, value_name = "FILE")]
    key_file: PathBuf,
    /// The folder of the results
    #[arg(long, value_name = "FOLDER", default_value = "results")]
    out: PathBuf,
    /// Into how many parts the class is cut
    #[arg(long, value_name = "N", default_value_t = 8, value_parser = clap::value_parser!(u32).range(1..=4000))]
    parts: u32,
}

impl Pack {
    /// Writes it, and says what to do with it.
    pub fn run(&self) -> Done {
        let Self::Slurm(slurm) = self;
        super::course::read(&slurm.course)?;
        let there = |path: &Path| {
            let shown = Untrusted::from(path).to_string();
            path.canonicalize()
                .map_err(|error| format!("{shown}: {error}"))
        };
        let job = Job {
            raybook: std::env::current_exe()?,
            hand_ins: there(&slurm.hand_ins)?,
            course: there(&slurm.course)?,
            key: there(&slurm.key_file)?,
            out: std::path::absolute(&slurm.out)?,
            parts: slurm.parts,
        };
        job.slurm(&slurm.folder)?;
        let submit = Untrusted::from(slurm.folder.join("submit.sh").as_path()).shell();
        say(format!("Next:  sh {submit}"));
        Ok(true)
    }
}
