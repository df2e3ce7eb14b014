//! `raybook check`: what is right, what is not, and the next step.

use super::{Done, Target};
use indicatif::ProgressBar;
use raybook::grade::check::{Report, State, check};
use raybook::grade::converse::{Limits, Program};
use raybook::grade::dress::Dress;
use raybook::grade::examine::{Examiner, visible_rng};
use raybook::grade::feedback;
use raybook::grade::hidden::Key;
use raybook::grade::progress::{Progress, Standing};
use raybook::grade::{cases, json, library, student};
use raybook::image::file;
use raybook::lab::sheet::sheet;
use raybook::workbook::curriculum::CHAPTERS;
use std::error::Error;
use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Checks a workbook, or any answer program.
#[derive(clap::Args)]
pub struct Check {
    #[command(flatten)]
    target: Target,
    /// Ask only the case of this number
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    case: Option<u32>,
    /// Ask this program instead of building the workbook's: any program that answers a line per line
    #[arg(long)]
    program: Option<PathBuf>,
    /// Ask the hidden cases that belong to this course key and --student
    #[arg(long, requires = "student")]
    key: Option<String>,
    /// Whose hidden cases
    #[arg(long, requires = "key")]
    student: Option<String>,
    /// The term of the hidden cases
    #[arg(long, default_value = "", requires = "key")]
    term: String,
    /// How long to wait for one answer, in seconds
    #[arg(long, default_value_t = 2.0, value_parser = seconds)]
    time_limit: f32,
    /// Print JSON (its fields are described in `raybook::grade::json`)
    #[arg(long)]
    json: bool,
    /// No colours and no symbols beyond ASCII
    #[arg(long)]
    plain: bool,
}

fn seconds(text: &str) -> Result<f32, String> {
    text.parse()
        .ok()
        .filter(|&s| s > 0.0 && s <= 3600.0)
        .ok_or_else(|| "a number of seconds, above 0 and at most 3600".to_owned())
}

impl Check {
    /// Checks, and tells; true if everything that was asked for is right.
    pub fn run(&self) -> Done {
        let (from, examiners) = self.target.resolve()?;
        if self.case.is_some() && examiners.len() != 1 {
            return Err("--case needs one exercise: raybook check sphere_hit --case 3".into());
        }
        let (program, folder) = self.program(&from)?;
        let bar = ProgressBar::new(examiners.len() as u64);
        let mut reports = Vec::new();
        for examiner in &examiners {
            let report = self.examine(&program, *examiner)?;
            let picture = self.keep_picture(&report, folder.as_deref())?;
            reports.push((report, picture));
            bar.inc(1);
        }
        bar.finish_and_clear();
        if let (Some(folder), None, None) = (&folder, self.case, &self.key) {
            remember(folder, &reports)?;
        }
        if self.json {
            println!("{:#}", json::results(&reports));
        } else {
            self.tell(&reports, folder.as_deref())?;
        }
        Ok(reports
            .iter()
            .all(|(report, _)| report.state() == State::Right))
    }

    /// The program to ask, and the workbook it is of, if it is.
    fn program(&self, from: &Path) -> Result<(Program, Option<PathBuf>), Box<dyn Error>> {
        if let Some(file) = &self.program {
            // A bare name would be looked for on the PATH.
            let file = std::path::absolute(file)?;
            return Ok((
                Program {
                    file,
                    arguments: Vec::new(),
                    folder: PathBuf::new(),
                },
                None,
            ));
        }
        let folder = student::workbook(from)?;
        Ok((student::build(&folder)?, Some(folder)))
    }

    fn examine(
        &self,
        program: &Program,
        examiner: &dyn Examiner,
    ) -> Result<Report, Box<dyn Error>> {
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
        let limits = Limits {
            time: Duration::from_secs_f32(self.time_limit),
            output: 1 << 20,
        };
        check(program, examiner, cases, limits)
            .map_err(|e| format!("{}: cannot be run: {e}", program.file.display()).into())
    }

    /// Writes the pictures of one exercise side by side; returns the file.
    fn keep_picture(
        &self,
        report: &Report,
        folder: Option<&Path>,
    ) -> Result<Option<PathBuf>, Box<dyn Error>> {
        let (Some(pictures), Some(folder), None) = (&report.pictures, folder, self.case) else {
            return Ok(None);
        };
        let [yours, golden, difference] =
            [&pictures.yours, &pictures.golden, &pictures.difference].map(|p| p.enlarged(4));
        let whole = sheet(
            3,
            &[
                ("yours", yours),
                ("right", golden),
                ("yours − right", difference),
            ],
        )?;
        let path = folder
            .join(".raybook")
            .join(format!("{}.png", report.exercise));
        file::save(&path, &whole)?;
        Ok(Some(path))
    }

    fn tell(
        &self,
        reports: &[(Report, Option<PathBuf>)],
        folder: Option<&Path>,
    ) -> Result<(), Box<dyn Error>> {
        let dress = self.dress();
        for chapter in CHAPTERS {
            let of_chapter: Vec<_> = chapter
                .exercises()
                .iter()
                .filter_map(|e| reports.iter().find(|(r, _)| r.exercise == e.name()))
                .collect();
            if of_chapter.is_empty() {
                continue;
            }
            println!("{} {}", chapter.number(), chapter.title());
            for (report, _) in &of_chapter {
                println!("  {}", feedback::line(report, dress));
            }
            let done = of_chapter
                .iter()
                .all(|(report, _)| report.state() == State::Right);
            if let (true, Some(folder), None) = (done, folder, self.case)
                && of_chapter.len() == chapter.exercises().len()
            {
                let names: Vec<_> = of_chapter
                    .iter()
                    .map(|(report, _)| report.exercise)
                    .collect();
                let path = keep_reference(folder, chapter.name, &names)?;
                println!(
                    "  reference solution: compare yours with {}",
                    path.display()
                );
            }
        }
        let wrong = reports
            .iter()
            .find(|(report, _)| report.state() == State::Wrong);
        if let Some((report, picture)) = wrong
            && let Some(examiner) = cases::find(report.exercise)
        {
            print!(
                "\n{}",
                feedback::explain(report, examiner, picture.as_deref(), dress)
            );
        }
        let right = reports
            .iter()
            .filter(|(report, _)| report.state() == State::Right)
            .count();
        println!("\n{right} of {} exercises are right.", reports.len());
        println!("{}", next_step(reports));
        Ok(())
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

fn next_step(reports: &[(Report, Option<PathBuf>)]) -> String {
    let first =
        |state: fn(&State) -> bool| reports.iter().map(|(r, _)| r).find(|r| state(&r.state()));
    let place = |report: &Report| library::place(report.exercise).unwrap_or_default();
    if let Some(report) = first(|state| *state == State::Wrong) {
        format!("Next: mend {} in {}.", report.exercise, place(report))
    } else if let Some(report) = first(|state| *state == State::NotStarted) {
        format!(
            "Next: write {0} in {1}; `raybook exercise {0}` says what it is asked.",
            report.exercise,
            place(report)
        )
    } else if let Some(report) = first(|state| matches!(state, State::WaitsFor(_))) {
        format!("Next: write what {} waits for.", report.exercise)
    } else {
        "Everything that was asked for is right.".to_owned()
    }
}

/// Keeps how the exercises stand in the student's folder.
fn remember(folder: &Path, reports: &[(Report, Option<PathBuf>)]) -> std::io::Result<()> {
    let mut progress = Progress::load(folder);
    for (report, _) in reports {
        let state = json::state_name(&report.state()).0.to_owned();
        let standing = Standing {
            state,
            right: report.right(),
            asked: report.cases.len(),
        };
        progress
            .exercises
            .insert(report.exercise.to_owned(), standing);
    }
    progress.save(folder)
}

/// Writes a chapter's reference functions beside the student's, once these are right.
fn keep_reference(folder: &Path, chapter: &str, exercises: &[&str]) -> std::io::Result<PathBuf> {
    let texts = exercises
        .iter()
        .filter_map(|exercise| library::reference(exercise));
    let text = texts.collect::<Vec<_>>().join("\n");
    let path = folder
        .join(".raybook")
        .join(format!("{chapter}_reference.rs"));
    file::write_whole(&path, text.as_bytes())?;
    Ok(path)
}
