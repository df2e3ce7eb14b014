//! The largest number of a type, which an infinite or a far too large number becomes when it is made whole.

use super::{explanation, made};
use crate::diagnose::evidence::{Evidence, Item};
use crate::diagnose::fit::{Answers, Explanation};

/// The largest and the smallest number of the types of whole numbers.
const ENDS: [f64; 6] = [
    u32::MAX as f64,
    i32::MAX as f64,
    i32::MIN as f64,
    u64::MAX as f64,
    i64::MAX as f64,
    i64::MIN as f64,
];

pub fn explanations(evidence: &Evidence<'_>, base: &Answers) -> Option<Explanation> {
    let wrong = &evidence.items[..evidence.wrong];
    let first = wrong.iter().find_map(|item| ends(item).next())?.1;
    let with_ends = |i: usize, base: &[f64]| {
        let mut made = base.to_vec();
        for (k, end) in ends(&evidence.items[i]) {
            *made.get_mut(k)? = end;
        }
        Some(made)
    };
    Some(explanation(
        9,
        format!(
            "returns {first}, the end of its type's range: an infinite or far too large number was made a whole number"
        ),
        "Print the number before it is made whole, in the first of these cases: by what is it divided there?",
        made(base, with_ends),
    ))
}

/// Where an answer has the end of a type, and the right answer has not.
fn ends(item: &Item) -> impl Iterator<Item = (usize, f64)> {
    let both = item.got.iter().zip(item.golden()).enumerate();
    both.filter(|(_, (got, right))| ENDS.contains(got) && got != right)
        .map(|(k, (got, _))| (k, *got))
}
