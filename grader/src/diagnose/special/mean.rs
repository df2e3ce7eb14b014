//! A mean for a sum, or a sum for a mean: an answer that is divided by the length of a list of the question, or is not.

use super::{explanation, made};
use crate::diagnose::evidence::Evidence;
use crate::diagnose::fit::{Answers, Explanation};
use crate::layout::layout;
use raybook_workbook::kind::Kind;

pub fn explanations(evidence: &Evidence<'_>, base: &Answers) -> Vec<Explanation> {
    let asked = evidence.examiner.asked();
    if !matches!(asked.answer.kind, Kind::Number | Kind::Numbers(_)) {
        return Vec::new();
    }
    let lengths = |i: usize| {
        let lists = layout(asked.question, &evidence.items[i].question).lists;
        let lengths = lists.iter().map(|span| span.elements.len() as f64);
        lengths.collect::<Vec<_>>()
    };
    let most = (0..evidence.items.len()).map(|i| lengths(i).len()).max();
    let by = |list: usize, of: fn(f64, f64) -> f64| {
        made(base, |i, base| {
            let length = *lengths(i).get(list)?;
            Some(base.iter().map(|v| of(*v, length)).collect())
        })
    };
    let of_list = |list: usize| {
        [
            explanation(
                12,
                "divides by the length of the list, as for a mean",
                "Is a mean asked for, or a sum?",
                by(list, |v, length| v / length),
            ),
            explanation(
                12,
                "multiplies by the length of the list, as if a mean were not divided",
                "Is a sum asked for, or a mean?",
                by(list, |v, length| v * length),
            ),
        ]
    };
    (0..most.unwrap_or(0)).flat_map(of_list).collect()
}
