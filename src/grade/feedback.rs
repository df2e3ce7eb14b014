//! What a check says to a student, in words.

use crate::grade::ask::Said;
use crate::grade::check::{Outcome, Report, State};
use crate::grade::examine::Examiner;
use crate::grade::starter;
use std::fmt::Write;
use std::path::Path;

/// How text is dressed. A symbol or colour only ever repeats what a word says.
#[derive(Clone, Copy, Debug, Default)]
pub struct Dress {
    /// ANSI colours.
    pub colour: bool,
    /// Symbols beyond ASCII in front of words.
    pub symbols: bool,
}

impl Dress {
    fn paint(self, code: &str, text: &str) -> String {
        if self.colour {
            format!("\u{1b}[{code}m{text}\u{1b}[0m")
        } else {
            text.to_owned()
        }
    }

    /// The state as a symbol and a word.
    fn state(self, state: &State) -> String {
        let (symbol, colour, word) = match state {
            State::Right => ("✓", "32", "right"),
            State::Wrong => ("✗", "31", "wrong"),
            State::NotStarted => ("·", "2", "not started"),
            State::WaitsFor(_) => ("…", "2", "waits"),
        };
        let word = format!("{word:<11}");
        self.paint(
            colour,
            &if self.symbols {
                format!("{symbol} {word}")
            } else {
                word
            },
        )
    }
}

/// One line on an exercise: its state, its name, and how many cases are right.
pub fn line(report: &Report, dress: Dress) -> String {
    let state = report.state();
    let counts = match &state {
        State::NotStarted => String::new(),
        State::WaitsFor(name) => format!("for {name}"),
        State::Right | State::Wrong => {
            format!("{} of {} cases", report.right(), report.cases.len())
        }
    };
    format!("{} {:<20} {counts}", dress.state(&state), report.exercise)
        .trim_end()
        .to_owned()
}

/// The first wrong case of an exercise, what explains it, and how to ask it again; empty if nothing is wrong.
///
/// `picture` is the file in which the pictures were written.
pub fn explain(
    report: &Report,
    examiner: &dyn Examiner,
    picture: Option<&Path>,
    dress: Dress,
) -> String {
    let Some((number, outcome, why)) = report.first_wrong() else {
        return String::new();
    };
    let mut text = String::new();
    let title = format!(
        "{}, case {number} of {}: {}",
        report.exercise,
        report.cases.len(),
        outcome.case.name
    );
    let _ = writeln!(text, "{}", dress.paint("1", &title));
    let _ = writeln!(text, "  {why}.");
    question(&mut text, examiner, outcome);
    printed(&mut text, &outcome.reply.printed);
    if let Some(diagnosis) = &report.diagnosis {
        let _ = writeln!(
            text,
            "\n  Your answers are those of a function that {}: it explains {} of your {} wrong answers.\n  Hint: {}",
            dress.paint("1", diagnosis.name),
            diagnosis.explained,
            diagnosis.wrong,
            diagnosis.hint
        );
    } else {
        kinds(&mut text, report);
    }
    if let (Some(pictures), Some(path)) = (&report.pictures, picture) {
        let _ = writeln!(
            text,
            "\n  Picture: {} (yours, the right one, and the difference: orange where yours is too bright, blue where it is too dark)",
            path.display()
        );
        if let Some(bad) = &pictures.first_bad {
            let size = pictures.yours.width() * pictures.yours.height();
            let _ = writeln!(
                text,
                "  {} of its {size} pixels are wrong; the first, in column {} of row {}, asks",
                pictures.bad, bad.x, bad.y
            );
            let _ = writeln!(text, "      {} {}", report.exercise, bad.question);
            let _ = writeln!(
                text,
                "      right: {}; yours: {}",
                bad.golden,
                bad.got.as_deref().unwrap_or("nothing")
            );
        }
    }
    let _ = writeln!(
        text,
        "\n  Ask this case again: raybook check {} --case {number}",
        report.exercise
    );
    text
}

/// What was asked, what came back, and what was right.
fn question(text: &mut String, examiner: &dyn Examiner, outcome: &Outcome) {
    let mut rows: Vec<_> = examiner
        .question_parts(&outcome.case.question)
        .into_iter()
        .map(|(name, value)| ("asked", name, value))
        .collect();
    let answer_names = examiner.answer_names().join(" ");
    if let Said::Answer(answer) = &outcome.reply.said {
        rows.push(("yours", answer_names.clone(), answer.clone()));
    }
    for answer in &outcome.case.answers {
        rows.push(("right", answer_names.clone(), answer.clone()));
    }
    let widest = rows
        .iter()
        .map(|(_, name, _)| name.chars().count())
        .max()
        .unwrap_or(0);
    let mut last = "";
    for (kind, name, value) in &rows {
        let kind_once = if *kind == last { "" } else { *kind };
        let _ = writeln!(text, "    {kind_once:<6} {name:<widest$}   {value}");
        last = kind;
    }
}

/// The student's own prints.
fn printed(text: &mut String, printed: &str) {
    const MOST: usize = 12;
    let lines: Vec<_> = printed
        .lines()
        .filter(|line| !line.trim().is_empty())
        .collect();
    if lines.is_empty() {
        return;
    }
    let _ = writeln!(text, "  Printed on the way:");
    for line in lines.iter().take(MOST) {
        let shown: String = line
            .chars()
            .map(|c| {
                if c.is_control() && c != '\t' {
                    '\u{fffd}'
                } else {
                    c
                }
            })
            .take(160)
            .collect();
        let _ = writeln!(text, "    | {shown}");
    }
    if lines.len() > MOST {
        let _ = writeln!(text, "    | … and {} more lines", lines.len() - MOST);
    }
    if printed
        .lines()
        .any(|line| line.contains("= ") && !line.starts_with("= "))
    {
        let _ = writeln!(
            text,
            "  (An answer must begin its line with `= `. If one of these was meant to be one, end the print before it with a newline.)"
        );
    }
}

/// Where no mistake explains the answers: which kinds of cases are right, and which are wrong.
fn kinds(text: &mut String, report: &Report) {
    let named = |right: bool| {
        let outcomes = report
            .cases
            .iter()
            .filter(|outcome| !outcome.case.name.starts_with("random "));
        let of_kind = outcomes.filter(|outcome| {
            matches!(outcome.verdict, crate::grade::check::Verdict::Right) == right
        });
        of_kind
            .map(|outcome| outcome.case.name.as_str())
            .collect::<Vec<_>>()
            .join("; ")
    };
    let (wrong, right) = (named(false), named(true));
    if !wrong.is_empty() {
        let _ = writeln!(text, "\n  Wrong too: {wrong}.");
    }
    if !right.is_empty() {
        let _ = writeln!(text, "  Already right: {right}.");
    }
}

/// What an exercise asks: task, place, words, an example, the number of cases.
pub fn describe(examiner: &dyn Examiner) -> String {
    let cases = examiner
        .cases(&mut crate::grade::examine::visible_rng(examiner.name()))
        .cases;
    let mut text = format!("{}\n  {}\n", examiner.name(), examiner.task());
    if let Some(file) = starter::place(examiner.name()) {
        let _ = writeln!(text, "  Write it in {file}.");
    }
    let _ = writeln!(
        text,
        "\n  A question is the name and these words, on one line:"
    );
    let _ = writeln!(
        text,
        "    {} {}",
        examiner.name(),
        examiner.question_names().join(" ")
    );
    let _ = writeln!(text, "  An answer is `=` and these words:");
    let _ = writeln!(text, "    = {}", examiner.answer_names().join(" "));
    if let Some(case) = cases.first() {
        let _ = writeln!(text, "  For example ({}):", case.name);
        let _ = writeln!(
            text,
            "    {} {}\n    = {}",
            examiner.name(),
            case.question,
            case.answers[0]
        );
    }
    let _ = writeln!(
        text,
        "\n  {} cases are visible; `raybook check {}` asks them.",
        cases.len(),
        examiner.name()
    );
    text
}
