//! What a check says to a student, in words.

use crate::ask::Said;
use crate::check::{Mark, Outcome, Report, State};
use crate::diagnose::{Beside, Diagnosis};
use crate::dress::Dress;
use crate::examine::Examiner;
use crate::picture::words;
use crate::prints::{self, abbreviated, first_difference, short};
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_workbook::curriculum;
use std::path::Path;

/// One line on an exercise: its state, its name, and how many cases are right.
pub fn line(report: &Report, dress: Dress) -> String {
    let state = report.state();
    let counts = match &state {
        State::NotStarted => String::new(),
        State::WaitsFor(name) if report.right() == 0 => format!("for {name}"),
        State::WaitsFor(name) => format!("for {name}; {}", score(report)),
        State::Right | State::Wrong => score(report) + words::but(report),
    };
    format!("{} {:<20} {counts}", dress.state(&state), report.exercise)
        .trim_end()
        .to_owned()
}

/// How many cases are right, and how many of the others are still to do.
fn score(report: &Report) -> String {
    let outcomes = report.cases.iter();
    let to_do = match outcomes.filter(|o| o.is_to_do(report.exercise)).count() {
        0 => String::new(),
        count => format!(", {count} to do"),
    };
    let (right, all) = (report.right(), report.cases.len());
    format!("{right} of {all} cases right{to_do}")
}

/// What a student can type next.
#[derive(Clone, Copy, Debug)]
pub struct Commands<'a> {
    /// Asks a case again, but for its number.
    pub again: &'a str,
    /// Explains the exercise, if it can be explained.
    pub explain: Option<&'a str>,
}

/// The wrong case of an exercise that the mistake explains, or else the first, and what explains it, or the pictures that are wrong; empty
/// if nothing is wrong.
///
/// `picture` is the file in which the pictures were written.
pub fn explain(
    report: &Report,
    examiner: &dyn Examiner,
    picture: Option<&Path>,
    commands: Commands<'_>,
    dress: Dress,
) -> String {
    let Some((outcome, _)) = report.shown_wrong() else {
        return words::alone(report, picture, dress);
    };
    let shown = report.smallest.as_ref().unwrap_or(outcome);
    let mut lines: Vec<_> = already_right(report).into_iter().collect();
    lines.extend(case(report, examiner, shown, dress));
    if report.cases.len() > 1 {
        lines.push(String::new());
        lines.extend(diagnosis(report, dress));
    }
    if let Some(path) = picture {
        lines.push(String::new());
        lines.extend(words::wrong(report, path));
    } else if let Some(why) = &report.stopped {
        lines.extend([String::new(), format!("  No picture: {why}.")]);
    }
    let number = outcome.case.number;
    let this = match report.smallest {
        Some(_) => "the case as it was",
        None => "this case again",
    };
    lines.extend([
        String::new(),
        format!("  Ask {this}: {} --case {number}", commands.again),
    ]);
    let explain = commands.explain;
    lines
        .extend(explain.map(|command| format!("  See it step by step: {command} --case {number}")));
    lines.extend(derived(report.exercise));
    lines.push(String::new());
    lines.join("\n")
}

/// Some of the cases that are right, by name.
fn already_right(report: &Report) -> Option<String> {
    /// More names nobody reads first.
    const NAMED: usize = 3;
    let right = report
        .cases
        .iter()
        .filter(|outcome| outcome.verdict == Mark::Right);
    let named = right.filter(|outcome| !outcome.case.is_random());
    let names = named.map(|outcome| format!("\"{}\"", Untrusted::from(outcome.case.name.as_str())));
    let names: Vec<_> = names.take(NAMED).collect();
    let (right, all) = (report.right(), report.cases.len());
    (!names.is_empty()).then(|| {
        format!(
            "Right already: {right} of {all} cases, such as {}.\n",
            names.join(", ")
        )
    })
}

/// Where the book derives an exercise.
pub fn derived(exercise: &str) -> Option<String> {
    let chapter = curriculum::of_exercise(exercise)?;
    let (number, title) = (chapter.number(), chapter.title);
    let short = &chapter.name[..4];
    Some(format!(
        "  Chapter {number} of the book, \"{title}\", derives it: raybook book {short}"
    ))
}

/// One case: what is wrong with it, what was asked and answered, and the student's prints.
pub fn case(
    report: &Report,
    examiner: &dyn Examiner,
    outcome: &Outcome,
    dress: Dress,
) -> Vec<String> {
    let mut lines = heading(report, outcome, dress);
    lines.extend(asked(examiner, outcome));
    lines.extend(prints::printed(outcome));
    lines
}

/// What explains the wrong answers of an exercise: a mistake, or else which kinds of cases are wrong.
pub fn diagnosis(report: &Report, dress: Dress) -> Vec<String> {
    let mut lines = match &report.diagnosis {
        Some(diagnosis) => diagnosed(diagnosis, dress),
        None => kinds(report),
    };
    lines.extend(unread_infinity(report));
    lines
}

/// Which case it is, and what is wrong with it.
pub fn heading(report: &Report, outcome: &Outcome, dress: Dress) -> Vec<String> {
    let title = format!(
        "{}, case {}: {}",
        report.exercise,
        outcome.case.number,
        Untrusted::from(outcome.case.name.as_str())
    );
    let verdict = match &outcome.verdict {
        Mark::Right => "  Right.".to_owned(),
        Mark::NotStarted => "  Not written yet.".to_owned(),
        Mark::Wrong(why) => {
            let why = capitalised(why) + outcome.reply.said.help();
            format!("  {}", ended(&why))
        }
    };
    vec![dress.paint("1", &title), verdict]
}

/// The sentence with its full stop, if it has no mark of its own.
pub fn ended(sentence: &str) -> String {
    let stop = if sentence.ends_with('?') { "" } else { "." };
    format!("{sentence}{stop}")
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
    let cut = |parts: Vec<(String, String)>, from: &dyn Fn(usize) -> usize| {
        let parts = parts.into_iter().enumerate();
        let parts = parts.map(|(i, (name, words))| (name, abbreviated(&words, from(i))));
        parts.collect()
    };
    add(
        "asked",
        cut(examiner.question_parts(&outcome.case.question), &|_| 0),
    );
    let yours = match &outcome.reply.said {
        Said::Answer(answer) => examiner.answer_parts(answer.unescaped()),
        _ => Vec::new(),
    };
    let right: Vec<_> = outcome.case.answers.iter().collect();
    let first = right
        .first()
        .map(|answer| examiner.answer_parts(answer))
        .unwrap_or_default();
    // Of a long list, what is shown begins where the answers part.
    let parting = |i: usize| match (yours.get(i), first.get(i)) {
        (Some((_, a)), Some((_, b))) => first_difference(a, b),
        _ => 0,
    };
    let shown = |(name, value): (String, String)| (name, short(&value.into()));
    add(
        "yours",
        cut(yours.clone(), &parting)
            .into_iter()
            .map(shown)
            .collect(),
    );
    for (i, answer) in right.into_iter().enumerate() {
        add(
            if i == 0 { "right" } else { "or" },
            cut(examiner.answer_parts(answer), &parting),
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

/// What explains the wrong answers: as a fact if all answers speak for it, else as what it looks like. Two mistakes that only together
/// explain the same answers, or each of which does, are told in one sentence.
fn diagnosed(diagnosis: &Diagnosis, dress: Dress) -> Vec<String> {
    let of = |beside: Beside| {
        diagnosis
            .also
            .iter()
            .filter(move |also| also.beside == beside)
    };
    let mut names = dress.paint("1", &diagnosis.name);
    let mut hints = vec![&diagnosis.hint];
    for (also, word) in of(Beside::Together)
        .map(|also| (also, "and also"))
        .chain(of(Beside::Instead).map(|also| (also, "or")))
    {
        names = format!("{names}, {word} {}", dress.paint("1", &also.name));
        if !hints.contains(&&also.hint) {
            hints.push(&also.hint);
        }
    }
    let first = match diagnosis.beside {
        Beside::Shown => shown(diagnosis, &names),
        _ => explained(diagnosis, &names, ""),
    };
    let mut lines = vec![first];
    lines.extend(hints.into_iter().map(|hint| format!("  Hint: {hint}")));
    for also in of(Beside::Apart) {
        lines.push(explained(also, &dress.paint("1", &also.name), "And "));
        lines.push(format!("  Hint: {}", also.hint));
    }
    for seen in of(Beside::Shown) {
        lines.push(shown(seen, &dress.paint("1", &seen.name)));
        lines.push(format!("  Hint: {}", seen.hint));
    }
    lines.extend(unexplained(diagnosis));
    lines
}

/// What is there to see in the answers, by this name.
fn shown(seen: &Diagnosis, name: &str) -> String {
    match seen.wrong {
        1 => format!("  It shows in the wrong answer: your function {name}."),
        wrong => format!(
            "  It shows in {} of the {wrong} wrong answers: your function {name}.",
            seen.explained
        ),
    }
}

/// What is said of the wrong answers that no mistake explains. Of an answer in parts each part has its own.
fn unexplained(diagnosis: &Diagnosis) -> Option<String> {
    let apart = diagnosis.also.iter();
    let apart = apart.filter(|also| [Beside::Apart, diagnosis.beside].contains(&also.beside));
    if diagnosis.part.is_some() || apart.clone().any(|also| also.part.is_some()) {
        return None;
    }
    let explained = diagnosis.explained + apart.map(|also| also.explained).sum::<usize>();
    let other = match diagnosis.wrong.saturating_sub(explained) {
        0 => return None,
        1 => "the other wrong answer".to_owned(),
        left => format!("the other {left} wrong answers"),
    };
    Some(match diagnosis.beside {
        Beside::Shown => format!("  It does not show in {other}."),
        _ => format!("  This does not explain {other}: mend it, and check again."),
    })
}

/// What a mistake of this name explains, behind a word that joins it to the one before.
fn explained(diagnosis: &Diagnosis, name: &str, and: &str) -> String {
    let Diagnosis {
        part,
        certain,
        explained,
        wrong,
        further,
        ..
    } = diagnosis;
    let and = match (and, part) {
        (and, None) => and.to_owned(),
        ("", Some(part)) => format!("In {part}: "),
        (and, Some(part)) => format!("{and}in {part}: "),
    };
    let your = if and.is_empty() { "Your" } else { "your" };
    if *certain {
        let wrong = match wrong {
            1 => "the wrong one".to_owned(),
            _ => format!("{explained} of the {wrong} wrong ones"),
        };
        let further = match further {
            0 => String::new(),
            _ => format!(
                ", and {further} of {further} to further questions that were asked to be sure"
            ),
        };
        format!(
            "  {and}{your} answers are those of a function that {name}: this explains {wrong}{further}."
        )
    } else {
        let look = match (explained, wrong) {
            (_, 1) if and.is_empty() => "The wrong answer looks".to_owned(),
            (_, 1) => "the wrong answer looks".to_owned(),
            (1, _) => format!("1 of the {wrong} wrong answers looks"),
            _ => format!("{explained} of the {wrong} wrong answers look"),
        };
        format!("  {and}{look} as if your function {name}. This is not certain.")
    }
}

/// Where the wrong cases are those with `inf` in their question, and no others.
fn unread_infinity(report: &Report) -> Option<String> {
    let infinite = |outcome: &&Outcome| {
        let mut words = outcome.case.question.split_whitespace();
        words.any(|word| word.trim_start_matches('-') == "inf")
    };
    let wrong = |outcome: &&Outcome| matches!(outcome.verdict, Mark::Wrong(_));
    let both = report.cases.iter().filter(infinite).filter(wrong).count();
    let is_pattern = both > 1
        && both < report.cases.len()
        && report
            .cases
            .iter()
            .all(|outcome| infinite(&outcome) == wrong(&outcome));
    is_pattern.then(|| {
        "  Wrong are exactly the cases with `inf` in their question: is it read as a number? In C++ `std::cin >> x` does not; read a word and call `std::strtod`.".to_owned()
    })
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
        let all = report.cases.iter();
        let of_kind = all.filter(|outcome| (outcome.verdict == Mark::Right) == right);
        let (random, named): (Vec<_>, Vec<_>) =
            of_kind.partition(|outcome| outcome.case.is_random());
        let names = named
            .into_iter()
            .map(|outcome| Untrusted::from(outcome.case.name.as_str()).to_string());
        let random = match random.len() {
            0 => None,
            1 => Some("a random one".to_owned()),
            many => Some(format!("{many} random ones")),
        };
        names.chain(random).collect::<Vec<_>>().join("; ")
    };
    let kinds = [("Wrong", named(false)), ("Right", named(true))];
    kinds
        .into_iter()
        .filter(|(_, names)| !names.is_empty())
        .map(|(what, names)| format!("  {what} are: {names}."))
        .collect()
}
