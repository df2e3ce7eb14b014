//! `raybook hint`: a nudge that does not give the answer away.

use super::asking::Asking;
use super::{Done, Target};
use raybook_chapters::kit::say::say;
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_grader::ask::Asker;
use raybook_grader::check::{State, check};
use raybook_grader::examine::Examiner;
use raybook_grader::examine::visible_rng;
use raybook_grader::prints::abbreviated;
use raybook_grader::student;
use raybook_workbook::curriculum::{CHAPTERS, Chapter};

/// Hints at what is wrong.
#[derive(clap::Args)]
pub struct Hint {
    #[command(flatten)]
    target: Target,
    #[command(flatten)]
    asking: Asking,
}

impl Hint {
    /// Asks the program, and hints at the first exercise that is not right.
    pub fn run(&self) -> Done {
        let (from, examiners) = self.target.resolve()?;
        let (program, workbook) = self.asking.program(&from, Vec::new())?;
        let mut asker = Asker::new(&program, self.asking.limits());
        for examiner in examiners {
            let report = check(
                &mut asker,
                examiner,
                examiner.cases(&mut visible_rng(examiner.name())).cases,
            )?;
            let name = report.exercise;
            match (report.state(), &report.diagnosis, report.first_wrong()) {
                (State::Right, ..) => continue,
                (State::NotStarted, ..) => {
                    say(first_step(examiner));
                    if let Some(file) = workbook.and_then(|folder| student::place(&folder, name)) {
                        say(format!("Write it in {file}."));
                    }
                }
                (State::WaitsFor(other), ..) => {
                    say(format!(
                        "{name} calls {other}, which you have not written yet."
                    ));
                }
                (State::Wrong, Some(diagnosis), _) => say(format!("{name}: {}", diagnosis.hint)),
                (State::Wrong, None, first) => {
                    let (case, why) =
                        first.map_or(("", ""), |(outcome, why)| (outcome.case.name.as_str(), why));
                    let case = Untrusted::from(case);
                    say(format!("{name}: think of the case \"{case}\": {why}."));
                }
            }
            return Ok(true);
        }
        say("Nothing to hint at: everything that was asked for is right.");
        Ok(true)
    }
}

/// What leads on where nothing is written yet: the easiest case to do by hand, what to think of, and where it is derived.
fn first_step(examiner: &dyn Examiner) -> String {
    let name = examiner.name();
    let cases = examiner.cases(&mut visible_rng(name)).cases;
    let mut lines = Vec::new();
    // The first named case is the simplest that people thought of; one without anything to find teaches nothing.
    let case = cases
        .iter()
        .find(|case| !["none", "0"].contains(&case.answers[0].as_str()));
    if let Some(case) = case {
        lines.push(format!("{name}: do one case by hand first, {}.", case.name));
        let shown = |lines: &mut Vec<String>, what: &str, parts: Vec<(String, String)>| {
            for (part, words) in parts {
                lines.push(format!(
                    "    {what:<6} {part:<12} {}",
                    abbreviated(&words, 0)
                ));
            }
        };
        shown(&mut lines, "given", examiner.question_parts(&case.question));
        shown(&mut lines, "right", examiner.answer_parts(&case.answers[0]));
    }
    if let Some((_, hint)) = examiner.mistakes().first() {
        lines.push(format!("  And think of this: {hint}"));
    }
    let holds = |chapter: &&Chapter| chapter.exercises().iter().any(|e| e.name == name);
    if let Some(chapter) = CHAPTERS.iter().find(holds) {
        lines.push(format!(
            "  Chapter {} of the book, \"{}\", derives it.",
            chapter.number(),
            chapter.title
        ));
    }
    lines.join("\n")
}
