//! What the questions with a wrong answer have in common, and no others: a number that is 0, a direction along an axis, two points one
//! above the other, an empty list.

use super::beyond::{self, value};
use super::evidence::{Evidence, Item};
use super::{Beside, Diagnosis};
use crate::layout::{Part, layout, parts};
use raybook_workbook::kind::{Kind, VECTOR};

/// A regime is told if this many answers are right: with all wrong, nothing sets it apart.
const RIGHT: usize = 8;

/// Of fewer wrong answers it is not said that what is seen in them is seen nowhere else: of one alone, much is true.
const ENOUGH: usize = 2;

/// What leads on.
const HINT: &str = "Go through the first of these questions by hand, line by line: which of your steps makes no sense there, such as the division by a length of 0?";

/// A property of a question, in words: “`b` is 0”.
pub struct Regime {
    pub words: String,
    /// Of each item, whether its question has the property.
    pub holds: Vec<bool>,
}

/// Where the answers are wrong, if no mistake is known that gives them.
pub fn search(evidence: &Evidence<'_>) -> Option<Diagnosis> {
    let words = shared(evidence)?;
    let name = format!("is wrong where {words}, and only there");
    Some(told(name, evidence.wrong, evidence.wrong))
}

/// Says of what is seen in the wrong answers where it is seen, for then it is no mistake of all answers.
pub fn add_to(seen: &mut Diagnosis, evidence: &Evidence<'_>) {
    if evidence.wrong < ENOUGH {
        return;
    }
    if let Some(words) = property(evidence, &wrong(evidence)) {
        seen.name = format!("{}, but only where {words}", seen.name);
        HINT.clone_into(&mut seen.hint);
    }
}

/// Of each item, whether its answer is wrong.
fn wrong(evidence: &Evidence<'_>) -> Vec<bool> {
    (0..evidence.items.len())
        .map(|i| i < evidence.wrong)
        .collect()
}

/// What the questions with a wrong answer have in common, and no others.
pub fn shared(evidence: &Evidence<'_>) -> Option<String> {
    apart(evidence, &wrong(evidence))
}

/// What the questions of these items have in common, and no others: a property, or that they are beyond a limit.
fn apart(evidence: &Evidence<'_>, inside: &[bool]) -> Option<String> {
    property(evidence, inside).or_else(|| beyond::search(evidence, inside))
}

/// The property that the questions of these items have, and no others.
fn property(evidence: &Evidence<'_>, inside: &[bool]) -> Option<String> {
    let count = inside.iter().filter(|inside| **inside).count();
    if count == 0 || inside.len() - count < RIGHT.max(count) {
        return None;
    }
    let mut regimes = regimes(evidence).into_iter();
    let found = regimes.find(|regime| regime.holds == inside);
    found.map(|regime| regime.words)
}

/// Where the wrong answers are of which these are no explanation.
pub fn of_rest(evidence: &Evidence<'_>, answers: &[Option<Vec<f64>>]) -> Option<Diagnosis> {
    let is_left = |i: usize| {
        i < evidence.wrong
            && !answers[i]
                .as_ref()
                .is_some_and(|answer| evidence.explains(i, answer))
    };
    let left: Vec<_> = (0..evidence.items.len()).map(is_left).collect();
    let words = apart(evidence, &left)?;
    let count = left.iter().filter(|left| **left).count();
    Some(told(
        format!("goes wrong in another way where {words}"),
        count,
        evidence.wrong,
    ))
}

/// What is seen in some of the wrong answers.
fn told(name: String, explained: usize, wrong: usize) -> Diagnosis {
    Diagnosis {
        name,
        hint: HINT.to_owned(),
        part: None,
        certain: false,
        explained,
        wrong,
        further: 0,
        shown: None,
        beside: Beside::Apart,
        also: Vec::new(),
    }
}

/// What the questions with a wrong answer have in common, be it that others have it too.
pub fn of_wrong(evidence: &Evidence<'_>) -> Vec<Regime> {
    let mut all = regimes(evidence);
    all.retain(|regime| regime.holds[..evidence.wrong].iter().all(|holds| *holds));
    all
}

fn regimes(evidence: &Evidence<'_>) -> Vec<Regime> {
    let kind = evidence.examiner.asked().question;
    let parts = parts(kind, "question");
    let mut all = Vec::new();
    let mut add = |words: String, holds: &dyn Fn(&Item) -> bool| {
        let holds = evidence.items.iter().map(holds).collect();
        all.push(Regime { words, holds });
    };
    let alone: Vec<_> = parts
        .iter()
        .enumerate()
        .filter(|(_, part)| part.list.is_none())
        .collect();
    for (i, part) in &alone {
        let name = &part.name;
        let each = |holds: &dyn Fn(&[f64]) -> bool, item: &Item| {
            value(kind, *i, item).is_some_and(|value| holds(&value))
        };
        match part.kind {
            Kind::Number | Kind::Whole => {
                add(format!("`{name}` is 0"), &|q| each(&|v| v[0] == 0.0, q));
                add(format!("`{name}` is negative"), &|q| {
                    each(&|v| v[0] < 0.0, q)
                });
                add(format!("`{name}` is infinite"), &|q| {
                    each(&|v| v[0].is_infinite(), q)
                });
            }
            Kind::Direction => {
                for (axis, k) in VECTOR.parts.iter().zip(0..) {
                    add(format!("`{name}` is parallel to the {axis} axis"), &|q| {
                        each(&|v| is_along(v, k), q)
                    });
                    add(format!("`{name}` goes down along {axis}"), &|q| {
                        each(&|v| v[k] < 0.0, q)
                    });
                    add(format!("`{name}` goes up along {axis}"), &|q| {
                        each(&|v| v[k] > 0.0, q)
                    });
                }
            }
            Kind::Numbers(numbers) if numbers.name == "Interval" => {
                for (end, k) in numbers.parts.iter().zip(0..) {
                    add(format!("`{name}.{end}` is negative"), &|q| {
                        each(&|v| v[k] < 0.0, q)
                    });
                }
            }
            _ => {}
        }
    }
    let is_point =
        |part: &Part| matches!(part.kind, Kind::Numbers(numbers) if numbers.name == VECTOR.name);
    let points: Vec<_> = alone.iter().filter(|(_, part)| is_point(part)).collect();
    for (k, (i, one)) in points.iter().enumerate() {
        for (j, other) in &points[k + 1..] {
            for (axis, along) in VECTOR.parts.iter().zip(0..) {
                let words = format!(
                    "the way from `{}` to `{}` is parallel to the {axis} axis",
                    one.name, other.name
                );
                add(words, &|q| {
                    let both = value(kind, *i, q).zip(value(kind, *j, q));
                    both.is_some_and(|(a, b)| {
                        let way: Vec<_> = a.iter().zip(&b).map(|(a, b)| b - a).collect();
                        is_along(&way, along)
                    })
                });
            }
        }
    }
    let lists = parts.iter().filter_map(|part| Some((part.list?, part)));
    for (list, part) in lists {
        let count = |q: &Item| {
            let spans = layout(kind, &q.question).lists;
            let span = spans.into_iter().find(|span| span.list == list);
            span.map(|span| span.elements.len())
        };
        let name = &part.name;
        add(format!("the list ({name}) is empty"), &|q| {
            count(q) == Some(0)
        });
        add(format!("the list ({name}) has one element"), &|q| {
            count(q) == Some(1)
        });
    }
    all
}

/// Whether a vector has this component only.
fn is_along(v: &[f64], axis: usize) -> bool {
    let mut each = v.iter().enumerate();
    each.all(|(k, v)| (k == axis) == (*v != 0.0))
}
