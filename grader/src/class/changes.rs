//! What changes when grades are written anew: who, from how much to how much, and why.

use super::grades::points;
use super::roll::{Class, Written};
use std::collections::BTreeMap;

/// A student whose grade changes.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// The student.
    pub student: String,
    /// Points before, and points that could be reached; `None` if the student is new.
    pub before: Option<[f64; 2]>,
    /// Points now, and points that can be reached; `None` if there is no hand-in of the student any more.
    pub after: Option<[f64; 2]>,
    /// Why, each a sentence without its end.
    pub why: Vec<String>,
}

/// The changes from what was written to the grades of a class.
pub fn changes(before: &BTreeMap<String, Written>, class: &Class<'_>) -> Vec<Change> {
    let now: BTreeMap<_, _> = class
        .grades
        .iter()
        .map(|grade| (&grade.sheet.student, Written::of(grade)))
        .collect();
    let mut students: Vec<_> = before.keys().chain(now.keys().copied()).collect();
    students.sort();
    students.dedup();
    let change = |student: &String| {
        let (old, new) = (before.get(student), now.get(student));
        (old != new).then(|| Change {
            student: student.clone(),
            before: old.map(|written| [written.points, written.of]),
            after: new.map(|written| [written.points, written.of]),
            why: match (old, new) {
                (Some(old), Some(new)) => why(old, new),
                (None, _) => vec!["new".to_owned()],
                (_, None) => vec!["there is no hand-in any more".to_owned()],
            },
        })
    };
    students.into_iter().filter_map(change).collect()
}

fn why(old: &Written, new: &Written) -> Vec<String> {
    let mut why = differences(&old.exercises, &new.exercises, |value| points(*value));
    let days = differences(&old.days_late, &new.days_late, i64::to_string);
    why.extend(
        days.into_iter()
            .map(|chapter| format!("days late of {chapter}")),
    );
    if old.of != new.of {
        why.push(format!(
            "what can be reached: {} → {}",
            points(old.of),
            points(new.of)
        ));
    }
    if why.is_empty() {
        why.push("weights, or what late days cost".to_owned());
    }
    why
}

fn differences<T: PartialEq>(
    old: &BTreeMap<String, T>,
    new: &BTreeMap<String, T>,
    text: impl Fn(&T) -> String,
) -> Vec<String> {
    let mut names: Vec<_> = old.keys().chain(new.keys()).collect();
    names.sort();
    names.dedup();
    let text = |value: Option<&T>| value.map_or_else(|| "nothing".to_owned(), &text);
    let of = |name: &&String| {
        let (a, b) = (old.get(*name), new.get(*name));
        (a != b).then(|| format!("{name}: {} → {}", text(a), text(b)))
    };
    names.iter().filter_map(of).collect()
}
