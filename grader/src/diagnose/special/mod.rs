//! Answers as a whole: the same one to every question or none, lists in another order, parts exchanged, the other way round.

mod alike;
mod clamped;
mod largest;
mod lists;
mod mean;
mod nothing;
mod parts;

use super::evidence::{Evidence, Scope};
use super::fit::{Answers, Explanation};
use raybook_workbook::kind::Kind;

/// The rank of what is there to see in the answers, and needs no guess.
pub const SEEN: u32 = 4;

/// The explanations that look at an answer as a whole, or at its shape.
pub fn explanations(evidence: &Evidence<'_>, base: &Answers) -> Vec<Explanation> {
    if matches!(evidence.scope, Scope::Part(_)) {
        return Vec::new();
    }
    let before = made(base, |i, _| evidence.items[i].previous.clone());
    let mut all = vec![explanation(
        9,
        "gives the answer to the question before",
        "Is every answer written as soon as its question is read, or one too late? Does anything stay in a variable from the last call?",
        before,
    )];
    all.extend(alike::explanations(evidence, base));
    all.extend(clamped::explanations(evidence, base));
    all.extend(largest::explanations(evidence, base));
    all.extend(lists::explanations(evidence, base));
    all.extend(mean::explanations(evidence, base));
    all.extend(nothing::explanations(evidence, base));
    if evidence.scope == Scope::Whole {
        all.extend(parts::explanations(evidence, base));
    }
    all.extend(the_other_way_round(evidence, base));
    all
}

/// The explanation of answers 0 and 1 that are taken for each other.
fn the_other_way_round(evidence: &Evidence<'_>, base: &Answers) -> Option<Explanation> {
    let answer = &evidence.examiner.asked().answer;
    let (yes, no) = (vec![1.0], vec![0.0]);
    let is_yes_or_no = |row: &Vec<f64>| *row == yes || *row == no;
    let all_are = matches!(answer.kind, Kind::Whole) && base.iter().flatten().all(is_yes_or_no);
    all_are.then(|| {
        explanation(
            9,
            format!(
                "answers the other way round: 1 for 0 in {}, and 0 for 1",
                answer.name
            ),
            "What does a 1 mean, and what a 0?",
            made(base, |_, base| Some(vec![1.0 - base[0]])),
        )
    })
}

/// An explanation without a fitted number.
fn explanation(
    rank: u32,
    name: impl Into<String>,
    hint: impl Into<String>,
    answers: Answers,
) -> Explanation {
    Explanation {
        name: name.into(),
        hint: hint.into(),
        rank,
        fitted: 0,
        answers,
    }
}

/// What is made of each right answer, by the number of its item.
fn made(base: &Answers, make: impl Fn(usize, &[f64]) -> Option<Vec<f64>>) -> Answers {
    let base = base.iter().enumerate();
    base.map(|(i, base)| make(i, base.as_ref()?)).collect()
}
