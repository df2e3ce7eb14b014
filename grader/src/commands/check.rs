//! `raybook check`: what is right, what is not, and the next step.

use super::asking::{Asking, program_at};
use super::golden::Golden;
use super::keep::keep_pictures;
use super::tell::Telling;
use super::{Done, Target};
use indicatif::ProgressBar;
use raybook_chapters::kit::say::say;
use raybook_grader::check::{State, check_all};
use raybook_grader::dress::Dress;
use raybook_grader::examine::{Case, Examiner, visible_rng};
use raybook_grader::hidden::Key;
use raybook_grader::json;
use raybook_grader::progress::Progress;
use rayon::prelude::*;
use std::io::IsTerminal;
use std::path::{Path, PathBuf};

/// Checks a workbook, or any answer program.
#[derive(clap::Args)]
pub struct Check {
    #[command(flatten)]
    target: Target,
    #[command(flatten)]
    golden: Golden,
    /// Ask only the case of this number
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    case: Option<u32>,
    #[command(flatten)]
    asking: Asking,
    /// Ask the hidden cases that belong to this course key and --student
    #[arg(long, requires = "student")]
    key: Option<String>,
    /// Whose hidden cases
    #[arg(long, requires = "key")]
    student: Option<String>,
    /// The term of the hidden cases
    #[arg(long, default_value = "", requires = "key")]
    term: String,
    /// Write the pictures that the answers make into this folder; without it, those of the workbook in which you are are kept in its .raybook
    #[arg(long, value_name = "FOLDER")]
    pictures: Option<PathBuf>,
    /// Print JSON (its fields are described in `raybook_grader::json`)
    #[arg(long)]
    json: bool,
    /// No colours and no symbols in front of words
    #[arg(long)]
    plain: bool,
}

impl Check {
    /// Checks, and tells; true if everything that was asked for is right.
    pub fn run(&self) -> Done {
        let (from, examiners) = self.target.resolve()?;
        let examiners = self.golden.replace(examiners)?;
        if self.case.is_some() && examiners.len() != 1 {
            return Err("--case needs one exercise: raybook check sphere_hit --case 3".into());
        }
        let (program, folder) = program_at(self.asking.program.as_deref().unwrap_or(&from))?;
        let gallery = self.gallery(folder.as_deref());
        let bar = ProgressBar::new(examiners.len() as u64);
        let exercises = examiners
            .par_iter()
            .map(|examiner| Ok((*examiner, self.cases(*examiner)?)));
        let exercises = exercises.collect::<Result<Vec<_>, String>>()?;
        let limits = self.asking.limits();
        let reports = check_all(&program, &exercises, limits, gallery.is_some(), &|| {
            bar.inc(1);
        })?;
        bar.finish_and_clear();
        let mut pictured = Vec::new();
        for report in reports {
            let picture = keep_pictures(&report, gallery.as_deref())?;
            pictured.push((report, picture));
        }
        let reports = pictured;
        if let (Some(folder), None, None) = (&folder, self.case, &self.key) {
            Progress::remember(folder, reports.iter().map(|(report, _)| report))?;
        }
        if self.json {
            say(format!("{:#}", json::results(&reports)));
        } else {
            let whole = self.case.is_none();
            Telling {
                folder: folder.as_deref().filter(|_| whole),
                again: &|exercise| self.again(exercise),
                dress: self.dress(),
            }
            .tell(&reports, whole)?;
        }
        Ok(reports
            .iter()
            .all(|(report, _)| report.state() == State::Right))
    }

    /// The cases that are asked of an exercise.
    fn cases(&self, examiner: &dyn Examiner) -> Result<Vec<Case>, String> {
        let mut rng = match (&self.key, &self.student) {
            (Some(course), Some(student)) => Key {
                course: course.clone(),
                term: self.term.clone(),
                student: student.clone(),
            }
            .rng(examiner.name()),
            _ => visible_rng(examiner.name()),
        };
        let mut cases = examiner.cases(&mut rng).cases;
        if let Some(number) = self.case {
            let count = cases.len();
            let case = cases.into_iter().nth(number as usize - 1);
            cases = vec![case.ok_or_else(|| {
                format!(
                    "{} has {count} cases, there is no case {number}",
                    examiner.name()
                )
            })?];
        }
        Ok(cases)
    }

    /// Where pictures go; nowhere if a single case is asked.
    fn gallery(&self, workbook: Option<&Path>) -> Option<PathBuf> {
        let of_workbook = || Some(workbook?.join(".raybook"));
        let folder = self.pictures.clone().or_else(of_workbook);
        folder.filter(|_| self.case.is_none())
    }

    /// The command that asks a case of an exercise again, but for its number: what was typed, with this exercise only.
    fn again(&self, exercise: &str) -> String {
        let mut words = vec!["raybook check".to_owned(), exercise.to_owned()];
        words.extend(self.target.folder().map(|folder| format!("{folder:?}")));
        if let Some(student) = &self.student {
            words.push(format!(
                "--key … --term {:?} --student {student:?}",
                self.term
            ));
        }
        words.join(" ") + &self.asking.again()
    }

    fn dress(&self) -> Dress {
        let colour = std::io::stdout().is_terminal()
            && std::env::var_os("NO_COLOR").is_none_or(|v| v.is_empty());
        Dress {
            colour: colour && !self.plain,
            symbols: !self.plain,
        }
    }
}
