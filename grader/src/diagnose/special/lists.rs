//! Lists whose elements are left out, doubled, or in another order.

use super::{explanation, made};
use crate::diagnose::evidence::Evidence;
use crate::diagnose::fit::{Answers, Explanation};
use crate::layout::layout;
use std::cmp::Ordering;

/// What may become of a list.
struct Change {
    rank: u32,
    name: &'static str,
    hint: &'static str,
    /// Of a list of n elements, the numbers of those that are returned, in their order.
    which: fn(usize) -> Vec<usize>,
}

macro_rules! changes {
    ($($rank:literal $name:literal $hint:literal: $which:expr;)+) => {
        const CHANGES: &[Change] = &[$(Change { rank: $rank, name: $name, hint: $hint, which: $which }),+];
    };
}

changes! {
    11 "returns the list backwards" "In which order is the list wanted, and in which do you make it?": |n| (0..n).rev().collect();
    11 "leaves out the first of the list" "Where does your loop begin?": |n| (1..n).collect();
    11 "leaves out the last of the list" "Where does your loop end?": |n| (0..n.saturating_sub(1)).collect();
    12 "returns the first of the list only" "What makes your loop end?": |n| (0..n.min(1)).collect();
    12 "returns the last of the list only" "Is the list overwritten in every round?": |n| (n.saturating_sub(1)..n).collect();
    12 "returns the first half of the list only" "What makes your loop end?": |n| (0..n / 2).collect();
    12 "returns every second of the list only" "By how much does your counter grow in a round?": |n| (0..n).step_by(2).collect();
    12 "returns an empty list" "Is anything ever appended to your list?": |_| Vec::new();
    12 "returns the last of the list twice" "Where does your loop end?": |n| (0..n).chain(n.checked_sub(1)).collect();
    12 "returns the first of the list twice" "Is the first appended before the loop and in it?": |n| (0..n.min(1)).chain(0..n).collect();
    12 "returns everything in the list twice" "How often is each appended?": |n| (0..n).chain(0..n).collect();
    13 "begins the list with its second element, and ends it with the first" "Where does your loop begin?":
        |n| (1..n).chain(0..n.min(1)).collect();
    13 "begins the list with its last element" "Where does your loop begin?":
        |n| (n.saturating_sub(1)..n).chain(0..n.saturating_sub(1)).collect();
}

pub fn explanations(evidence: &Evidence<'_>, base: &Answers) -> Vec<Explanation> {
    let kind = evidence.examiner.asked().answer.kind;
    let some = base.iter().flatten().find(|row| row.len() > 1);
    let fields = layout(kind, some.map_or(&[], |row| row));
    let lists = fields.lists.iter().map(|span| span.list + 1).max();
    let mut all = Vec::new();
    for list in 0..lists.unwrap_or(0) {
        for change in CHANGES {
            let answers = made(base, |_, base| {
                Some(layout(kind, base).rearranged(base, list, &change.which))
            });
            all.push(explanation(change.rank, change.name, change.hint, answers));
        }
        all.push(explanation(
            13,
            "sorts the list",
            "In which order is the list wanted?",
            sorted(evidence, base, list),
        ));
    }
    all
}

/// The answers with a list sorted, if an answer holds this list once.
fn sorted(evidence: &Evidence<'_>, base: &Answers, list: usize) -> Answers {
    let kind = evidence.examiner.asked().answer.kind;
    made(base, |_, base| {
        let fields = layout(kind, base);
        let mut spans = fields.lists.iter().filter(|span| span.list == list);
        let span = spans.next()?;
        if spans.next().is_some() {
            return None;
        }
        let keys = |n: usize| {
            let mut order: Vec<_> = (0..n).collect();
            order.sort_by(|a, b| {
                let [a, b] = [a, b].map(|i| &base[span.elements[*i].clone()]);
                let first = a.iter().zip(b).map(|(a, b)| a.total_cmp(b));
                first.fold(Ordering::Equal, Ordering::then)
            });
            order
        };
        Some(fields.rearranged(base, list, &keys))
    })
}
