//! `raybook check`: what is right, what is not, and the next step.

use super::asking::Asking;
use super::golden::Golden;
use super::hidden::Hidden;
use super::keep::{keep_pictures, right_pictures};
use super::manner::Manner;
use super::tell::{Pictured, Telling};
use super::unwritten::Unwritten;
use super::{Done, Target};
use indicatif::ProgressBar;
use raybook_chapters::kit::say::{complain, say};
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_grader::again::ask_alone;
use raybook_grader::ask::Asker;
use raybook_grader::check::{Outcome, Report, State, check_all};
use raybook_grader::converse::{Limits, Program};
use raybook_grader::examine::{Case, Examiner, visible_rng};
use raybook_grader::hidden::Key;
use raybook_grader::picture::ask::Pixels;
use raybook_grader::progress::Progress;
use raybook_grader::rare::Depth;
use raybook_grader::{json, shrink};
use rayon::prelude::*;
use std::collections::HashMap;
use std::error::Error;
use std::io;
use std::path::{Path, PathBuf};
use std::time::{SystemTime, UNIX_EPOCH};

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
    #[command(flatten)]
    hidden: Hidden,
    /// Write the pictures that the answers make into this folder; without it, a workbook keeps them in its .raybook, where one that is right is not drawn again as long as its function is right. Elsewhere a few pixels are asked, and all if one of these is wrong: pictures count like cases
    #[arg(long, value_name = "FOLDER")]
    pictures: Option<PathBuf>,
    #[command(flatten)]
    manner: Manner,
}

/// What a program may miss that ends without an answer.
const IN_THE_SANDBOX: &str = "
It ran in a sandbox: it reads its own folder and the system's files, writes nothing, and starts no process (in a shell script,
`exec` your program). --trust runs it with all your rights.";

/// Finds the smallest wrong question of the exercise that is told in full: the first that is wrong. There is none if the case that is
/// shown is right where nothing was asked before it.
fn find_smallest(
    program: &Program,
    limits: Limits,
    exercises: &[(&dyn Examiner, Vec<Case>)],
    reports: &mut [Report],
) -> io::Result<()> {
    let is_wrong = |(_, report): &(_, &mut Report)| report.state() == State::Wrong;
    if let Some(((examiner, _), report)) = exercises.iter().zip(reports).find(is_wrong) {
        let mut asker = Asker::new(program, limits);
        if let Some(place) = report.place_shown()
            && ask_alone(&mut asker, *examiner, report, place)?
        {
            return Ok(());
        }
        let mut ask = |questions: &[String]| asker.ask(questions);
        if let Some((outcome, _)) = report.shown_wrong() {
            let mistake = report.mistake_of_some(*examiner);
            report.smallest = shrink::smallest(&mut ask, *examiner, outcome, mistake)?;
        }
    }
    Ok(())
}

impl Check {
    /// Checks, and tells; true if everything that was asked for is right.
    pub fn run(&self) -> Done {
        let reports = self.reports(self.manner.json)?;
        let is_right = |report: &Report| report.state() == State::Right;
        Ok(reports.iter().all(is_right))
    }

    /// Checks, and tells; returns what became of each exercise, and if they are to be `drawn` all its pictures, else those that are not
    /// there yet.
    pub fn reports(&self, drawn: bool) -> Result<Vec<Report>, Box<dyn Error>> {
        let (from, examiners) = self.target.resolve()?;
        let examiners = self.golden.replace(examiners)?;
        if self.case.is_some() && examiners.len() != 1 {
            return Err("--case needs one exercise: raybook check sphere_hit --case 3".into());
        }
        let key = self.hidden.key()?;
        let unreadable = self.hidden.file().chain(self.golden.folder());
        let unreadable = unreadable.map(Path::to_owned).collect();
        let (program, folder) = self.asking.program(&from, unreadable)?;
        let gallery = self.gallery(folder.as_deref());
        let bar = ProgressBar::new(examiners.len() as u64);
        let exercises = examiners
            .par_iter()
            .map(|examiner| Ok((*examiner, self.cases(*examiner, key.as_ref())?)));
        let exercises = exercises.collect::<Result<Vec<_>, String>>()?;
        let limits = self.asking.limits();
        let is_kept = self.pictures.is_none() && key.is_none() && !drawn;
        let before = gallery.as_deref().filter(|_| is_kept);
        let before = |one: &&dyn Examiner| Some((one.name(), right_pictures(*one, before?)?));
        let mut before: HashMap<_, _> = examiners.par_iter().filter_map(before).collect();
        let round = SystemTime::now().duration_since(UNIX_EPOCH);
        let round = round.map_or(0, |since| since.as_secs()); // another one at each check
        let pixels = |examiner: &dyn Examiner| match (self.case, &gallery) {
            (Some(_), _) => Pixels::None,
            (None, None) => Pixels::Some,
            (None, Some(_)) if before.contains_key(examiner.name()) => Pixels::Renewed(round),
            (None, Some(_)) => Pixels::All,
        };
        // With a course's key, as a class is graded.
        let depth = key.as_ref().map_or(Depth::Check, |_| Depth::Grade);
        let done = || bar.inc(1);
        let mut reports = check_all(&program, &exercises, limits, &pixels, depth, &done)?;
        bar.finish_and_clear();
        if self.case.is_none() && key.is_none() {
            find_smallest(&program, limits, &exercises, &mut reports)?;
        }
        // What cannot be written must not keep the verdict back.
        let mut unwritten = Unwritten::default();
        let mut pictured = Vec::new();
        for (report, (examiner, _)) in reports.into_iter().zip(&exercises) {
            let kept = keep_pictures(
                &report,
                *examiner,
                gallery.as_deref(),
                self.pictures.is_none(),
            );
            let picture = unwritten.or_none(kept);
            let is_before = report.pictures.is_empty() && report.state() == State::Right;
            let before = before.remove(report.exercise).filter(|_| is_before);
            pictured.push((report, picture.flatten().or(before)));
        }
        let reports = pictured;
        if let (Some(folder), None, None) = (&folder, self.case, &key) {
            let reports = reports.iter().map(|(report, _)| report);
            if let Some(Some(aside)) = unwritten.or_none(Progress::remember(folder, reports)) {
                complain(format!(
                    "note: the progress kept in this workbook was damaged; it is now in {}, and a new one begins",
                    Untrusted::from(aside.as_path())
                ));
            }
        }
        if self.manner.json {
            say(json::text(&json::results(&reports)));
        } else {
            let whole = self.case.is_none();
            Telling {
                folder: folder.as_deref().filter(|_| whole),
                again: &|exercise| self.again(exercise),
                explain: &|exercise| self.explain(exercise),
                dress: self.manner.look.dress(),
            }
            .tell(&reports, whole, &mut unwritten);
            let ended = |(report, _): &Pictured| report.cases.iter().any(Outcome::ended);
            if program.sandbox.is_some() && reports.iter().any(ended) {
                say(IN_THE_SANDBOX);
            }
        }
        unwritten.said()?;
        Ok(reports.into_iter().map(|(report, _)| report).collect())
    }

    /// The cases that are asked of an exercise.
    fn cases(&self, examiner: &dyn Examiner, key: Option<&Key>) -> Result<Vec<Case>, String> {
        let name = examiner.name();
        let mut rng = key.map_or_else(|| visible_rng(name), |key| key.rng(name));
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
        self.command("check", exercise) + &self.hidden.again() + &self.asking.again()
    }

    /// The command that explains an exercise; none for cases of a key or a folder, which it does not ask.
    fn explain(&self, exercise: &str) -> Option<String> {
        let asks_the_same = self.hidden.again().is_empty() && self.golden.folder().is_none();
        asks_the_same.then(|| self.command("explain", exercise) + &self.asking.again())
    }

    /// A command on an exercise of the program that is checked.
    fn command(&self, command: &str, exercise: &str) -> String {
        let mut words = vec![format!("raybook {command}"), exercise.to_owned()];
        words.extend(
            self.target
                .folder()
                .map(|folder| Untrusted::from(folder).shell()),
        );
        words.join(" ")
    }
}
