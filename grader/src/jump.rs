//! Questions just where an answer jumps: at an end of an interval, at a tie, at a threshold. Found out by moving each number of a question a little.

use crate::examine::{Case, Examiner};
use crate::layout::{Leaf, Part, layout, parts};
use raybook_workbook::kind::Kind;

/// How far a number is moved, as a part of it, or of 1 if it is smaller: two of the last digits of a number near 1.
const STEP: f64 = 2.4e-7;

/// An answer that becomes another when a number of its question is moved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Jump {
    /// Any number, but for those of an interval.
    Elsewhere,
    /// An end of the interval that is this part of the question: it is excluded if the answer jumps when the interval grows.
    End {
        /// The part.
        part: usize,
        /// Whether the answer jumps when the interval grows.
        excluded: bool,
    },
}

/// Whether a part is an interval.
pub fn is_interval(part: &Part) -> bool {
    matches!(part.kind, Kind::Numbers(numbers) if numbers.parts == ["min", "max"])
}

/// The jumps of the answer just at a case's question. Where answers take long to find, they are looked for at the ends of intervals only.
pub fn jumps(examiner: &dyn Examiner, case: &Case) -> Vec<Jump> {
    let asked = examiner.asked();
    let Ok(question) = asked.read_question(&case.question) else {
        return Vec::new();
    };
    let Ok(golden) = examiner.reference(&question) else {
        return Vec::new();
    };
    let parts = parts(asked.question, "question");
    let jumps_at = |place: usize, step: f64| {
        let mut moved = question.clone();
        moved[place] += step * moved[place].abs().max(1.0);
        let answer = examiner.reference(&moved);
        answer.is_ok_and(|answer| examiner.compare(&question, &golden, &answer).is_err())
    };
    let mut found = Vec::new();
    for leaf in layout(asked.question, &question).leaves {
        let Leaf { part, start, len } = leaf;
        let is_moved = match parts[part].kind {
            Kind::Whole => false,
            _ => examiner.limits().effort == 1 || is_interval(&parts[part]),
        };
        for place in (start..start + len).filter(|&place| is_moved && question[place].is_finite()) {
            for step in [-STEP, STEP] {
                if jumps_at(place, step) {
                    let excluded = (place == start) == (step < 0.0);
                    found.push(if is_interval(&parts[part]) {
                        Jump::End { part, excluded }
                    } else {
                        Jump::Elsewhere
                    });
                }
            }
        }
    }
    found
}
