//! `raybook pack`: what another machine needs to grade.

use super::Done;
use raybook::store;
use raybook_chapters::kit::say::say;
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_grader::class::pack::beside::{Beside, beside};
use raybook_grader::class::pack::{Job, github, gradescope};
use std::path::{Path, PathBuf};

/// Where to grade.
#[derive(clap::Subcommand)]
pub enum Pack {
    /// Write scripts that grade a class as a job array of Slurm, on folders that all nodes see
    Slurm(Slurm),
    /// Write the zip of an autograder for Gradescope
    Gradescope(Gradescope),
    /// Write a repository for GitHub, whose workflow grades a class in parts at the same time
    Github(Github),
}

/// An autograder for Gradescope. It holds the course key: give it to nobody else.
#[derive(clap::Args)]
pub struct Gradescope {
    /// The zip to write
    #[arg(default_value = "autograder.zip")]
    zip: PathBuf,
    /// What counts, and how much. Gradescope knows what is late, so leave due times out
    #[arg(long, value_name = "FILE")]
    course: PathBuf,
    /// The file of the course key
    #[arg(long, value_name = "FILE")]
    key_file: PathBuf,
}

/// A repository for GitHub, which must be private. The course key is not in it, but one of its secrets.
#[derive(clap::Args)]
pub struct Github {
    /// The folder of the repository, a new one
    folder: PathBuf,
    /// What counts, and how much
    #[arg(long, value_name = "FILE")]
    course: PathBuf,
    /// Into how many parts the class is cut, as many jobs of the workflow
    #[arg(long, value_name = "N", default_value = "8", value_parser = clap::value_parser!(u32).range(1..=256))]
    parts: u32,
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
    #[arg(long, value_name = "N", default_value = "8", value_parser = clap::value_parser!(u32).range(1..=4000))]
    parts: u32,
}

impl Pack {
    /// Writes it, and says what to do with it.
    pub fn run(&self) -> Done {
        match self {
            Self::Slurm(slurm) => slurm.run(),
            Self::Gradescope(gradescope) => gradescope.run(),
            Self::Github(github) => github.run(),
        }
    }
}

/// The text of a course file, if it is right, and what is packed with it.
///
/// # Errors
/// If something in it is wrong, or what belongs to it lies elsewhere.
fn course(file: &Path) -> Result<(Vec<u8>, Vec<Beside>), Box<dyn std::error::Error>> {
    let course = super::course::read(file)?;
    Ok((store::read(file)?, beside(&course, file)?))
}

impl Gradescope {
    fn run(&self) -> Done {
        let (course, beside) = course(&self.course)?;
        let key = super::hidden::read_key(&self.key_file)?;
        let raybook = store::read(&std::env::current_exe()?)?;
        let zip = gradescope::autograder(&raybook, &course, &beside, key.as_bytes())?;
        store::write(&self.zip, &zip)?;
        let shown = Untrusted::from(self.zip.as_path());
        say(format!(
            "wrote {shown}: upload it as the autograder of an assignment, on Ubuntu 24.04 or later"
        ));
        Ok(true)
    }
}

impl Github {
    fn run(&self) -> Done {
        let (course, beside) = course(&self.course)?;
        let raybook = store::read(&std::env::current_exe()?)?;
        github::repository(&self.folder, raybook, course, beside, self.parts)?;
        let shown = Untrusted::from(self.folder.as_path());
        say(format!(
            "wrote {shown}: put the hand-ins into hand-ins/, make a private repository of it whose secret COURSE_KEY is the course key, and run its workflow \"grade\""
        ));
        Ok(true)
    }
}

impl Slurm {
    fn run(&self) -> Done {
        let slurm = self;
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
