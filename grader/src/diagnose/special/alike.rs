//! The same answer to every question, or to every question that has none.

use super::{SEEN, explanation, made};
use crate::attempt::attempt;
use crate::diagnose::evidence::{Evidence, Item};
use crate::diagnose::fit::{Answers, Explanation};
use crate::diagnose::number::short;
use crate::explain::find;
use crate::explain::way::Way;
use raybook_workbook::kind::Kind;

pub fn explanations(evidence: &Evidence<'_>, base: &Answers) -> Vec<Explanation> {
    let mut all = Vec::new();
    all.extend(one_to_all(evidence, base));
    if let Kind::Optional(_) = evidence.examiner.asked().answer.kind {
        all.push(explanation(
            9,
            "always returns none",
            "Which of your conditions is never true? Print its ingredients for the first wrong case.",
            made(base, |_, _| Some(vec![0.0])),
        ));
        all.extend(one_for_none(evidence, base));
    }
    all
}

/// One answer to every question.
fn one_to_all(evidence: &Evidence<'_>, base: &Answers) -> Option<Explanation> {
    let [first, _, _, ..] = &evidence.items[..] else {
        return None;
    };
    let one = &first.got;
    if evidence.items.iter().any(|item| item.got != *one) {
        return None;
    }
    let kind = evidence.examiner.asked().answer.kind;
    let is_none = matches!(kind, Kind::Optional(_)) && *one == [0.0];
    let hint = Some(evidence).filter(|_| is_none).and_then(ways_to_none);
    let hint = hint.unwrap_or_else(|| {
        "Which of its arguments does your function use? Does it return what it calculates?"
            .to_owned()
    });
    let name = match in_words(kind, one) {
        Some(words) => format!("answers every question with {words}"),
        None => "gives the same answer to every question".to_owned(),
    };
    Some(explanation(
        SEEN,
        name,
        hint,
        made(base, |_, _| Some(one.clone())),
    ))
}

/// One answer to every question that has none.
fn one_for_none(evidence: &Evidence<'_>, base: &Answers) -> Option<Explanation> {
    let wrong = evidence.items.iter().take(evidence.wrong);
    let mut got = wrong.filter(|item| item.golden() == [0.0]);
    let one: &Item = got.next()?;
    let one = one.got.clone();
    if one.len() < 2 || got.any(|item| item.got != one) {
        return None;
    }
    let kind = match evidence.examiner.asked().answer.kind {
        Kind::Optional(kind) => kind,
        kind => kind,
    };
    let words = in_words(kind, &one[1..]).unwrap_or_else(|| "an answer".to_owned());
    let answer = |base: &[f64]| {
        if base == [0.0] {
            one.clone()
        } else {
            base.to_vec()
        }
    };
    Some(explanation(
        9,
        format!("returns {words} where there is nothing to return"),
        "How does an answer say that there is none? It is the word `none` in a line, `None` in Rust and in Python, `std::nullopt` in C++.",
        made(base, |_, base| Some(answer(base))),
    ))
}

/// A short answer in words; none of a long one.
fn in_words(kind: &Kind, answer: &[f64]) -> Option<String> {
    /// More numbers are not read at a glance.
    const SHORT: usize = 6;
    match (kind, answer) {
        (Kind::Optional(_), [0.0]) => Some("none".to_owned()),
        (Kind::List(_), [0.0]) => Some("an empty list".to_owned()),
        (Kind::Optional(_) | Kind::List(_), _) => None,
        (_, numbers) if numbers.len() <= SHORT => {
            let numbers: Vec<_> = numbers.iter().map(|v| short(*v)).collect();
            Some(numbers.join(" "))
        }
        _ => None,
    }
}

/// Of a function that always returns none, a question that leads on: where right ways end with nothing to return, by what they decide
/// there. Nothing if no step by step way is known.
fn ways_to_none(evidence: &Evidence<'_>) -> Option<String> {
    let explainer = find(evidence.examiner.asked().name)?;
    let mut ends: [Vec<String>; 2] = Default::default();
    for item in evidence.items.iter().filter(|item| item.golden() == [0.0]) {
        let last = attempt(|| {
            let mut way = Way::default();
            (explainer.work)(0, &item.question, &mut way);
            way.end().met.decisions.pop()
        });
        let Some(last) = last.flatten() else { continue };
        let (end, name) = (
            &mut ends[usize::from(last.held)],
            format!("“{}”", last.name),
        );
        if !end.contains(&name) {
            end.push(name);
        }
    }
    let [failed, held] = ends.map(|names| names.join(" or "));
    let ends = match (held.is_empty(), failed.is_empty()) {
        (true, true) => return None,
        (true, false) => format!("{failed} is false"),
        (false, true) => format!("{held} is true"),
        (false, false) => format!("{held} is true, or {failed} is false"),
    };
    Some(format!(
        "An answer is none where {ends}. Which of these is it in your program for the first wrong case? Print both sides of that comparison, and what they are made of."
    ))
}
