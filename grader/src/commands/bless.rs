//! `raybook bless`: completes the golden files: answers for the named cases, and the random cases.

use super::{Done, Target, exercises};
use raybook::store::{self, StoreError};
use raybook_chapters::kit::say::say;
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_grader::examine::{Cases, Examiner};
use raybook_grader::golden;
use raybook_grader::lock::Lock;
use std::error::Error;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// Completes the golden files: the named cases in them get the reference's answers, and the random cases are appended.
#[derive(clap::Args)]
pub struct Bless {
    #[command(flatten)]
    target: Target,
    /// The folder of the golden files, instead of the folder golden here
    #[arg(long, value_name = "FOLDER")]
    golden: Option<PathBuf>,
    /// Write nothing; say which files are not complete
    #[arg(long)]
    check: bool,
}

impl Bless {
    /// Completes them, and says how many random questions were thrown away; true if `--check` finds nothing to write.
    pub fn run(&self) -> Done {
        let (from, examiners) = self.target.resolve()?;
        let folder = self.golden.clone().unwrap_or_else(|| from.join("golden"));
        if !folder.is_dir() {
            return Err(format!(
                "{}: there is no such folder; bless is for the project's own folder, or name a folder of golden files by --golden",
                Untrusted::from(folder.as_path())
            )
            .into());
        }
        let _lock = (!self.check).then(|| Lock::on(&folder)).transpose()?;
        let (mut complete, mut wrong, mut blessed) = (true, Vec::new(), 0);
        let all = exercises(&self.target.what)?.is_empty();
        for examiner in examiners {
            let path = folder.join(golden::path(examiner.name()));
            // A lecturer's folder has the files that differ.
            if all && !path.exists() {
                continue;
            }
            blessed += 1;
            match self.bless(examiner, &path) {
                Ok(was_complete) => complete &= was_complete,
                Err(error) => wrong.push(format!("{}: {error}", Untrusted::from(path.as_path()))),
            }
        }
        if blessed == 0 {
            return Err(format!(
                "{}: there is no golden file here; that of an exercise is called {}",
                Untrusted::from(folder.as_path()),
                golden::path("sphere_hit")
            )
            .into());
        }
        if wrong.is_empty() {
            Ok(complete || !self.check)
        } else {
            Err(wrong.join("\n").into())
        }
    }

    /// Completes a file; whether it was complete.
    fn bless(&self, examiner: &'static dyn Examiner, path: &Path) -> Result<bool, Box<dyn Error>> {
        let kept = store::read_text(path).map_err(|error| refused(&error))?;
        let (text, cases) = golden::page(&*golden::replaced(examiner, kept.clone())?)?;
        if text != kept && !self.check {
            store::write(path, text.as_bytes()).map_err(|error| refused(&error))?;
        }
        say(format!(
            "{}: {}",
            Untrusted::from(path),
            self.told(&kept, &text, &cases)
        ));
        Ok(text == kept)
    }

    fn told(&self, kept: &str, text: &str, cases: &Cases) -> String {
        let percent = 100.0 * cases.thrown_away_fraction();
        let cases = format!(
            "{} cases; {percent:.0} % of the random questions thrown away",
            cases.cases.len()
        );
        let same = kept.lines().zip(text.lines()).take_while(|(a, b)| a == b);
        match (text == kept, self.check) {
            (true, _) => cases,
            (false, true) => format!("not complete, from line {} on", same.count() + 1),
            (false, false) => format!("{cases}; written anew"),
        }
    }
}

/// Why a file cannot be read or written, and what to do where there is none. Its name is said elsewhere.
fn refused(error: &StoreError) -> String {
    match error.reason.kind() {
        ErrorKind::NotFound => {
            "there is no such file; write named cases into it, each on a line: `name | question`"
                .to_owned()
        }
        _ => format!("cannot {}: {}", error.doing, error.reason),
    }
}
