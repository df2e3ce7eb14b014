//! `raybook hint`: a nudge that does not give the answer away.

use super::asking::Asking;
use super::manner::Look;
use super::{Done, Target};
use raybook_chapters::kit::say::say;
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_grader::ask::Asker;
use raybook_grader::check::{Outcome, Report, State, check};
use raybook_grader::examine::Examiner;
use raybook_grader::examine::visible_rng;
use raybook_grader::explain::account::Account;
use raybook_grader::explain::way::words;
use raybook_grader::prints::abbreviated;
use raybook_grader::{feedback, student};
use raybook_workbook::kind::Kind;

/// Hints at what is wrong.
#[derive(clap::Args)]
pub struct Hint {
    #[command(flatten)]
    target: Target,
    #[command(flatten)]
    asking: Asking,
    /// How much is told: 1 a question that leads on, 2 what your function does, 3 a line of the way to the right answer too
    #[arg(long, value_name = "1|2|3", default_value = "1", value_parser = clap::value_parser!(u8).range(1..=3))]
    level: u8,
    #[command(flatten)]
    look: Look,
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
            match (report.state(), &report.diagnosis, report.shown_wrong()) {
                (State::Right, ..) => continue,
                (State::NotStarted, ..) => {
                    say(first_step(examiner, &report, self.level));
                    if let Some(file) = workbook.and_then(|folder| student::place(&folder, name)) {
                        say(format!("Write it in {file}."));
                    }
                }
                (State::WaitsFor(other), ..) => {
                    say(format!(
                        "{name} calls {other}, which you have not written yet."
                    ));
                    return Ok(true);
                }
                (State::Wrong, Some(diagnosis), _) if self.level == 1 => {
                    say(format!("{name}: {}", diagnosis.hint));
                }
                (State::Wrong, _, first) => {
                    let (case, why) =
                        first.map_or(("", ""), |(outcome, why)| (outcome.case.name.as_str(), why));
                    let case = Untrusted::from(case);
                    say(format!(
                        "{name}: think of the case \"{case}\": {}",
                        feedback::ended(why)
                    ));
                    if self.level > 1 {
                        say(feedback::diagnosis(&report, self.look.dress()).join("\n"));
                    }
                }
            }
            match (self.level, report.shown_wrong()) {
                (3, Some((outcome, _))) => say(on_the_way(&report, examiner, outcome)),
                (3, None) => {}
                (level, _) => say(format!("More: raybook hint {name} --level {}", level + 1)),
            }
            return Ok(true);
        }
        say("Nothing to hint at: everything that was asked for is right.");
        Ok(true)
    }
}

/// One line of the way to the right answer of a case; where no way is known, a part of that answer.
fn on_the_way(report: &Report, examiner: &dyn Examiner, outcome: &Outcome) -> String {
    let account = Account::of(report, examiner, outcome);
    let case = Untrusted::from(outcome.case.name.as_str());
    let steps: Vec<_> = account
        .steps
        .iter()
        .filter(|step| !step.value.is_empty())
        .collect();
    // The first ones are known, and the last one is the answer.
    let before = steps.split_last().map_or(&[][..], |(_, before)| before);
    if let Some(step) = before.get(before.len() / 2) {
        let name = step.name.trim_end_matches(" =");
        let value = format!("{} {}", words(&step.value), step.unit);
        let value = value.trim_end();
        return format!("On the way to the right answer of \"{case}\": {name}: {value}.");
    }
    account.right.first().map_or_else(String::new, |part| {
        let words = abbreviated(part.words.unescaped(), 0);
        format!("The right answer of \"{case}\": {} is {words}.", part.name)
    })
}

/// Whether each list of a question has several elements: a tree of one box is a leaf, whatever the rule.
fn has_several(examiner: &dyn Examiner, question: &str) -> bool {
    let Kind::Record(record) = examiner.asked().question else {
        return true;
    };
    let lists = record.fields.iter();
    let lists = lists.filter(|field| matches!(field.kind, Kind::List(_)));
    let names: Vec<_> = lists.map(|field| field.name).collect();
    let parts = examiner.question_parts(question).into_iter();
    parts
        .filter(|(name, _)| names.contains(&&**name))
        .all(|(_, words)| !matches!(words.split_whitespace().next(), Some("0" | "1")))
}

/// What leads on where nothing is written yet: the easiest case to do by hand, what to think of, and where it is derived.
fn first_step(examiner: &dyn Examiner, report: &Report, level: u8) -> String {
    let name = examiner.name();
    let mut lines = Vec::new();
    // The first named case is the simplest that people thought of; one without anything to find teaches nothing.
    let teaches = |outcome: &&Outcome| !["none", "0"].contains(&outcome.case.answers[0].as_str());
    let mut some = report.cases.iter().filter(teaches);
    let outcome = some
        .clone()
        .find(|outcome| has_several(examiner, &outcome.case.question))
        .or_else(|| some.next());
    if let Some(Outcome { case, .. }) = outcome {
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
    for (_, hint) in examiner.mistakes().into_iter().take(level.into()) {
        lines.push(format!("  And think of this: {hint}"));
    }
    if let (3, Some(outcome)) = (level, outcome) {
        lines.push(format!("  {}", on_the_way(report, examiner, outcome)));
    }
    lines.extend(feedback::derived(name));
    lines.join("\n")
}
