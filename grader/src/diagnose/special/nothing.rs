//! A number that is 0, taken for nothing: `if (id)` is false for the number 0, in C++ and in Python.

use super::{explanation, made};
use crate::diagnose::evidence::Evidence;
use crate::diagnose::fit::{Answers, Explanation};
use crate::layout::{Part, layout};
use raybook_workbook::kind::Kind;

/// One for each number of an answer that may be none, or whose last field may be none.
pub fn explanations(evidence: &Evidence<'_>, base: &Answers) -> Vec<Explanation> {
    let kind = evidence.examiner.asked().answer.kind;
    let Some(first) = first_of_optional(kind) else {
        return Vec::new();
    };
    let parts = evidence.parts.iter().enumerate().skip(first);
    let numbers = parts
        .filter(|(_, part)| part.list.is_none() && matches!(part.kind, Kind::Number | Kind::Whole));
    let of_number = |(number, part): (usize, &Part)| {
        let without = |_: usize, base: &[f64]| {
            let fields = layout(kind, base);
            let mut answer = base.to_vec();
            if fields.of_part(number).any(|leaf| base[leaf.start] == 0.0) {
                // What comes before the first number of an optional value says whether there is one.
                answer.truncate(fields.of_part(first).next()?.start - 1);
                answer.push(0.0);
            }
            Some(answer)
        };
        explanation(
            10,
            format!("answers none where {} is 0", part.name),
            "Is `if (x)` true for a number x that is 0? Which question tells a number from nothing in your language?",
            made(base, without),
        )
    };
    numbers.map(of_number).collect()
}

/// The first part of what may be none: of all, or of the last field.
fn first_of_optional(kind: &Kind) -> Option<usize> {
    match kind {
        Kind::Optional(_) => Some(0),
        Kind::Record(record) => {
            let (last, before) = record.fields.split_last()?;
            let are_single = before
                .iter()
                .all(|field| matches!(field.kind, Kind::Number | Kind::Whole));
            (are_single && matches!(last.kind, Kind::Optional(_))).then_some(before.len())
        }
        _ => None,
    }
}
