//! What `raybook check` prints: a line per exercise, the first that is wrong in full, and the next step.

use super::next;
use super::unwritten::Unwritten;
use raybook::store::{self, StoreError};
use raybook_chapters::kit::say::say;
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_grader::check::{Report, State};
use raybook_grader::dress::Dress;
use raybook_grader::examine::Examiner;
use raybook_grader::feedback::Commands;
use raybook_grader::language::Language;
use raybook_grader::picture::words;
use raybook_grader::progress::{KEPT, Progress};
use raybook_grader::starter::{place, reference_file};
use raybook_grader::{cases, feedback, library, student};
use raybook_workbook::curriculum::{CHAPTERS, Chapter};
use std::path::{Path, PathBuf};

/// A report, and the file of its pictures.
pub type Pictured = (Report, Option<PathBuf>);

/// How to tell it.
pub struct Telling<'a> {
    /// The student's folder, if there is one.
    pub folder: Option<&'a Path>,
    /// The command that asks a case of an exercise again, but for its number.
    pub again: &'a dyn Fn(&str) -> String,
    /// The command that explains an exercise, if it asks the same cases.
    pub explain: &'a dyn Fn(&str) -> Option<String>,
    /// Colours and symbols.
    pub dress: Dress,
}

impl Telling<'_> {
    /// Prints the reports: `whole` ones, or of a single case each; and writes the reference of each chapter that is right into
    /// the student's folder.
    pub fn tell(&self, reports: &[Pictured], whole: bool, unwritten: &mut Unwritten) {
        for chapter in CHAPTERS {
            self.tell_chapter(chapter, reports, unwritten);
        }
        let wrong = reports
            .iter()
            .find(|(report, _)| report.state() == State::Wrong);
        if let Some((report, picture)) = wrong
            && let Some(examiner) = cases::find(report.exercise)
        {
            let again = (self.again)(report.exercise);
            let explain = (self.explain)(report.exercise);
            let commands = Commands {
                again: &again,
                explain: explain.as_deref(),
            };
            say(format!(
                "\n{}",
                feedback::explain(report, examiner, picture.as_deref(), commands, self.dress)
            ));
            if let Some(line) = self.debugger(report) {
                say(line);
            }
        } else if !whole {
            for (report, examiner) in reports
                .iter()
                .filter_map(|(report, _)| Some((report, cases::find(report.exercise)?)))
            {
                self.tell_cases(report, examiner);
            }
        }
        if whole {
            let right = reports
                .iter()
                .filter(|(report, _)| report.state() == State::Right)
                .count();
            // The program of a workbook answers `= todo` by itself.
            if let (Some(name), None) = (ignored(reports), self.folder) {
                say(format!(
                    "\nYour program says nothing to `{name}`, nor to some others: let it answer `= todo` to what it does not know. Then nobody waits for it, and what is not written counts as not started."
                ));
            }
            say(format!(
                "\n{right} of {} exercises are right.\n{}",
                reports.len(),
                self.next_step(reports)
            ));
        }
    }

    /// How to find the line at which a program in C++ ended, which without more it does not tell.
    fn debugger(&self, report: &Report) -> Option<String> {
        let folder = self.folder?;
        let (outcome, _) = report.shown_wrong()?;
        let can =
            student::language(folder) == Some(Language::Cpp) && folder.join("Makefile").is_file();
        (can && outcome.ended()).then(|| {
            format!(
                "  In which line it ended: make -j4 debug && raybook check {} --case {} --program build/debug/answer --trust\n",
                report.exercise, outcome.case.number
            )
        })
    }

    fn tell_chapter(&self, chapter: &Chapter, reports: &[Pictured], unwritten: &mut Unwritten) {
        let find = |name| {
            reports
                .iter()
                .map(|(report, _)| report)
                .find(|report| report.exercise == name)
        };
        let of_chapter: Vec<_> = chapter
            .exercises()
            .iter()
            .filter_map(|exercise| find(exercise.name))
            .collect();
        if of_chapter.is_empty() {
            return;
        }
        say(format!("{} {}", chapter.number(), chapter.title));
        for report in &of_chapter {
            say(format!("  {}", feedback::line(report, self.dress)));
            let picture = reports
                .iter()
                .find(|(of, _)| of.exercise == report.exercise)
                .and_then(|(_, picture)| picture.as_ref());
            if let (Some(picture), State::Right) = (picture, report.state()) {
                say(words::right(report, picture).join("\n"));
            }
        }
        let all_asked = of_chapter.len() == chapter.exercises().len();
        let all_right = of_chapter
            .iter()
            .all(|report| report.state() == State::Right);
        if let (true, true, Some(folder)) = (all_asked, all_right, self.folder)
            && let Some(path) = unwritten.or_none(keep_reference(folder, chapter))
        {
            say(format!(
                "  reference solution: compare yours with {}",
                Untrusted::from(path.as_path())
            ));
        }
    }

    fn next_step(&self, reports: &[Pictured]) -> String {
        let first =
            |state: fn(&State) -> bool| reports.iter().map(|(r, _)| r).find(|r| state(&r.state()));
        let open = first(|state| *state == State::Wrong)
            .or_else(|| first(|state| *state == State::NotStarted))
            .or_else(|| first(|state| matches!(state, State::WaitsFor(_))));
        if let Some(report) = open {
            return next::step(self.folder, report.exercise, Some(&report.state()));
        }
        let done = "Everything that was asked for is right.";
        let kept = |folder| Some((folder, Progress::load(folder).ok()?));
        match self.folder.and_then(kept) {
            Some((folder, progress)) => format!("{done}\n{}", next::in_course(folder, &progress)),
            None => done.to_owned(),
        }
    }

    fn tell_cases(&self, report: &Report, examiner: &dyn Examiner) {
        for outcome in &report.cases {
            say(format!(
                "\n{}",
                feedback::case(report, examiner, outcome, self.dress).join("\n")
            ));
        }
    }
}

/// An exercise to which a program says nothing at all, where it answers others.
fn ignored(reports: &[Pictured]) -> Option<&'static str> {
    let says_nothing = |report: &&Report| {
        let mut replies = report.cases.iter().map(|outcome| &outcome.reply.said);
        replies.all(|said| !said.is_line())
    };
    let reports = || reports.iter().map(|(report, _)| report);
    let answers = reports().any(|report| report.cases.iter().any(|o| o.reply.said.is_line()));
    let silent = reports().find(says_nothing).filter(|_| answers)?;
    Some(silent.exercise)
}

/// Writes a chapter's reference functions beside the student's, once these are right: in the student's language, if the course has them.
fn keep_reference(folder: &Path, chapter: &Chapter) -> Result<PathBuf, StoreError> {
    let names = || chapter.exercises().iter().map(|exercise| exercise.name);
    let language = student::language(folder).unwrap_or(Language::Rust);
    let text = match language {
        Language::Rust => names()
            .filter_map(library::reference)
            .collect::<Vec<_>>()
            .join("\n"),
        Language::Cpp | Language::Python => names()
            .find_map(|name| reference_file(language, &place(language, name)?))
            .unwrap_or_default(),
    };
    let ending = language.endings()[0];
    let path = folder
        .join(KEPT)
        .join(format!("{}_reference.{ending}", chapter.name));
    store::write(&path, text.as_bytes())?;
    Ok(path)
}
