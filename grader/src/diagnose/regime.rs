//! What the questions with a wrong answer have in common, and no others: a number that is 0, a direction along an axis, two points one
//! above the other, an empty list.

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
    Some(Diagnosis {
        name: format!("is wrong where {words}, and only there"),
        hint: HINT.to_owned(),
        part: None,
        certain: false,
        explained: evidence.wrong,
        wrong: evidence.wrong,
        shown: None,
        beside: Beside::Apart,
        also: Vec::new(),
    })
}

/// Says of what is seen in the wrong answers where it is seen, for then it is no mistake of all answers.
pub fn add_to(seen: &mut Diagnosis, evidence: &Evidence<'_>) {
    if evidence.wrong < ENOUGH {
        return;
    }
    if let Some(words) = shared(evidence) {
        seen.name = format!("{}, but only where {words}", seen.name);
        HINT.clone_into(&mut seen.hint);
    }
}

/// What the questions with a wrong answer have in common, and no others.
pub fn shared(evidence: &Evidence<'_>) -> Option<String> {
    let (wrong, right) = evidence.items.split_at(evidence.wrong);
    if wrong.is_empty() || right.len() < RIGHT.max(wrong.len()) {
        return None;
    }
    let tells = |regime: &Regime| {
        let (wrong, right) = regime.holds.split_at(wrong.len());
        wrong.iter().all(|holds| *holds) && !right.contains(&true)
    };
    regimes(evidence)
        .into_iter()
        .find(tells)
        .map(|regime| regime.words)
}

/// What the questions with a wrong answer have in common, be it that others have it too.
pub fn of_wrong(evidence: &Evidence<'_>) -> Vec<Regime> {
    let mut all = regimes(evidence);
    all.retain(|regime| regime.holds[..evidence.wrong].iter().all(|holds| *holds));
    all
}

/// The numbers of a part that is in no list, if it is there.
fn value(kind: &Kind, part: usize, item: &Item) -> Option<Vec<f64>> {
    let fields = layout(kind, &item.question);
    let leaf = fields.of_part(part).next()?;
    Some(item.question[leaf.range()].to_vec())
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
