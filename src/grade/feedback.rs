//! What a check says to a student, in words.

use crate::grade::ask::Said;
use crate::grade::check::{Outcome, Report, State, Verdict};
use crate::grade::diagnose::Diagnosis;
use crate::grade::dress::Dress;
use crate::grade::examine::Examiner;
use crate::grade::picture::Triple;
use std::path::Path;

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
    let name = report.exercise;
    let title = format!(
        "{name}, case {number} of {}: {}",
        report.cases.len(),
        outcome.case.name
    );
    let mut lines = vec![dress.paint("1", &title), format!("  {}.", capitalised(why))];
    lines.extend(asked(examiner, outcome));
    lines.extend(printed(outcome));
    lines.push(String::new());
    match &report.diagnosis {
        Some(diagnosis) => lines.extend(diagnosed(diagnosis, dress)),
        None => lines.extend(kinds(report)),
    }
    if let (Some(pictures), Some(path)) = (&report.pictures, picture) {
        lines.push(String::new());
        lines.extend(pictured(name, pictures, path));
    }
    lines.extend([
        String::new(),
        format!("  Ask this case again: raybook check {name} --case {number}"),
        String::new(),
    ]);
    lines.join("\n")
}

/// The sentence with a capital letter first, unless that is a name of its own: t, b1.
fn capitalised(sentence: &str) -> String {
    let mut letters = sentence.chars();
    match (letters.next(), letters.clone().next()) {
        // A formula's letter stays as it is.
        (Some(first), Some(second)) if second.is_alphabetic() => {
            first.to_uppercase().chain(letters).collect()
        }
        _ => sentence.to_owned(),
    }
}

/// What was asked, what came back, and what was right.
fn asked(examiner: &dyn Examiner, outcome: &Outcome) -> Vec<String> {
    let mut rows = Vec::new();
    let mut add = |kind: &'static str, parts: Vec<(String, String)>| {
        // The kind is said once, before its first part.
        let kinds = std::iter::once(kind).chain(std::iter::repeat(""));
        rows.extend(
            kinds
                .zip(parts)
                .map(|(kind, (name, value))| (kind, name, value)),
        );
    };
    add("asked", examiner.question_parts(&outcome.case.question));
    if let Said::Answer(answer) = &outcome.reply.said {
        add("yours", examiner.answer_parts(answer));
    }
    for (i, answer) in outcome.case.answers.iter().enumerate() {
        add(
            if i == 0 { "right" } else { "or" },
            examiner.answer_parts(answer),
        );
    }
    let widest = rows
        .iter()
        .map(|(_, name, _)| name.chars().count())
        .max()
        .unwrap_or(0);
    rows.iter()
        .map(|(kind, name, value)| format!("    {kind:<6} {name:<widest$}   {value}"))
        .collect()
}

/// The student's own prints.
fn printed(outcome: &Outcome) -> Vec<String> {
    /// More lines, or longer ones, nobody reads here.
    const MOST: usize = 12;
    const WIDEST: usize = 160;
    let visible = |c: char| {
        if c.is_control() && c != '\t' {
            '\u{fffd}'
        } else {
            c
        }
    };
    let printed: Vec<_> = outcome
        .reply
        .printed
        .lines()
        .filter(|line| !line.trim().is_empty())
        .collect();
    let mut lines = Vec::new();
    if !printed.is_empty() {
        lines.push("  Printed on the way:".to_owned());
    }
    lines.extend(printed.iter().take(MOST).map(|line| {
        format!(
            "    | {}",
            line.chars().map(visible).take(WIDEST).collect::<String>()
        )
    }));
    if printed.len() > MOST {
        lines.push(format!("    | … and {} more lines", printed.len() - MOST));
    }
    let swallowed = printed.iter().any(|line| line.contains("= "));
    if swallowed && !matches!(outcome.reply.said, Said::Answer(_)) {
        lines.push("  An answer must begin its line with `= `. Is one of these meant to be one? End the print before it with a newline.".to_owned());
    }
    lines
}

fn diagnosed(diagnosis: &Diagnosis, dress: Dress) -> [String; 2] {
    let Diagnosis {
        name,
        hint,
        explained,
        wrong,
    } = diagnosis;
    [
        format!(
            "  Your answers are those of a function that {}: this explains {explained} of the {wrong} wrong ones.",
            dress.paint("1", name)
        ),
        format!("  Hint: {hint}"),
    ]
}

/// Where no mistake explains the answers: which kinds of cases are right, and which are wrong.
fn kinds(report: &Report) -> Vec<String> {
    if report.right() == 0 {
        return vec![format!(
            "  None of the {} cases is right.",
            report.cases.len()
        )];
    }
    let named = |right: bool| {
        let outcomes = report
            .cases
            .iter()
            .filter(|outcome| !outcome.case.name.starts_with("random "));
        let of_kind = outcomes.filter(|outcome| (outcome.verdict == Verdict::Right) == right);
        of_kind
            .map(|outcome| outcome.case.name.as_str())
            .collect::<Vec<_>>()
            .join("; ")
    };
    let kinds = [("Wrong", named(false)), ("Right", named(true))];
    kinds
        .into_iter()
        .filter(|(_, names)| !names.is_empty())
        .map(|(what, names)| format!("  {what} are: {names}."))
        .collect()
}

/// Where the pictures are, and the ray of the first wrong pixel.
fn pictured(exercise: &str, pictures: &Triple, path: &Path) -> Vec<String> {
    let mut lines = vec![
        format!("  Picture: {}", path.display()),
        "  It shows yours, the right one, and the difference: orange where yours is too bright, blue where it is too dark.".to_owned(),
    ];
    if let Some(bad) = &pictures.first_bad {
        let pixels = pictures.yours.width() * pictures.yours.height();
        let got = bad.got.as_deref().unwrap_or("nothing");
        lines.extend([
            format!("  {} of {pixels} pixels are wrong; the first, in column {} of row {} from the top left, asks", pictures.bad, bad.x, bad.y),
            format!("      {exercise} {}", bad.question),
            format!("      yours: {got}; right: {}", bad.golden),
        ]);
    }
    lines
}
