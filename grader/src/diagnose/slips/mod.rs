//! Explanations by one step that goes wrong: the steps of `raybook explain` with another value at one of them, or another decision.
//! Every exercise with steps has them for nothing.

mod brackets;
mod fitted;
mod habits;
mod operands;
mod possible;

use super::evidence::Evidence;
use crate::attempt::attempt;
use crate::each::each;
use crate::explain::slip::{Change, Slip};
use crate::explain::way::{Walked, Way};
use crate::explain::{Explainer, find};
use crate::mutex::lock;
pub use fitted::fitted;
pub use possible::RANK;
use std::collections::HashMap;
use std::hash::{DefaultHasher, Hash, Hasher};

/// A way of an exercise with one slip.
pub struct Slipped {
    /// What the slip does, as a verb.
    pub name: String,
    /// What leads on.
    pub hint: String,
    /// How common it is.
    pub rank: u32,
    explainer: &'static Explainer,
    /// The number of the way.
    pub way: usize,
    slip: Slip,
    /// What tells the slip from others of its way, for functions cannot be compared: known once, for its answers are looked up a million times.
    id: u64,
    /// A longer way than this is nobody's: the slip has made a list of all numbers.
    most: usize,
}

impl Slipped {
    /// What is answered; nothing where the way has no end, or leads nowhere.
    pub fn answer(&self, question: &[f64]) -> Option<Vec<f64>> {
        self.gone(question).map(|(answer, _)| answer)
    }

    /// The same with the number of steps that were gone for it.
    fn gone(&self, question: &[f64]) -> Option<(Vec<f64>, usize)> {
        let work = |way: &mut Way| (self.explainer.work)(self.way, question, way);
        attempt(|| {
            let mut way = Way::with(self.slip).no_longer_than(self.most);
            let answer = work(&mut way);
            if !way.looks_ahead() {
                return (answer, way.length());
            }
            let mut right = Way::default();
            work(&mut right);
            let mut ahead = Way::with_ahead(self.slip, right.end());
            (work(&mut ahead), ahead.length())
        })
    }

    /// The same for an item, of which it is known once it was asked; nothing when slips have gone too many steps.
    pub fn answer_to(&self, evidence: &Evidence<'_>, item: usize) -> Option<Vec<f64>> {
        let item = &evidence.items[item];
        let of = (self.way, self.id, item.case);
        let tried = lock(&evidence.slips);
        if let Some(known) = tried.answers.get(&of) {
            return known.clone();
        }
        if tried.is_over {
            return None;
        }
        drop(tried);
        let (answer, steps) = match self.gone(&item.question) {
            Some((answer, steps)) => (Some(answer), steps),
            // A way without an end is gone as far as it may be.
            None => (None, self.most),
        };
        let tried = &mut *lock(&evidence.slips);
        if tried.answers.insert(of, answer.clone()).is_none() {
            tried.steps += steps;
        }
        answer
    }

    /// What is answered if another slip is made on the same way too.
    pub fn answer_with(&self, other: &Self, question: &[f64]) -> Option<Vec<f64>> {
        let both = [self.slip, other.slip];
        let mut way = Way::with_both(both).no_longer_than(self.most);
        attempt(|| (self.explainer.work)(self.way, question, &mut way))
    }

    /// Whether other slips have the same answers: what is compared shows only in what is decided, and a threshold of another size decides
    /// the same.
    pub fn is_doubtful(&self) -> bool {
        matches!(self.slip, Slip::Sides(..) | Slip::Near(..))
    }

    /// What is answered if the changed value is a little larger still; none of another slip, and of a common one. Where that is the same, as
    /// of a number that is rounded, other changes have the same answers too.
    pub fn answer_beside(&self, question: &[f64]) -> Option<Vec<f64>> {
        let Slip::Value(at, _) = self.slip else {
            return None;
        };
        if self.rank < RANK + RARE {
            return None;
        }
        let larger = Slip::Value(at, Change::Each(|v| 1.02 * v));
        let mut way = Way::with_both([self.slip, larger]).no_longer_than(self.most);
        attempt(|| (self.explainer.work)(self.way, question, &mut way))
    }

    /// Whether a value is wrong, and not a decision or a loop.
    pub fn is_of_a_value(&self) -> bool {
        matches!(
            self.slip,
            Slip::Value(..) | Slip::Other { .. } | Slip::Mix { .. } | Slip::Bracket(..)
        )
    }

    /// Whether another slip can be made on the same way too.
    pub fn goes_with(&self, with: &Self) -> bool {
        // Of one value its numbers by themselves, as their signs, and all together, as its length.
        let apart = |one: Slip, other: Slip| {
            matches!(one, Slip::Value(_, Change::Each(_)))
                && matches!(other, Slip::Value(_, Change::Together(_)))
        };
        let (one, other) = (self.slip, with.slip);
        let elsewhere = one.place() != other.place();
        self.way == with.way && (elsewhere || apart(one, other) || apart(other, one))
    }

    /// How many steps the way to an answer has.
    pub fn length(&self, question: &[f64]) -> usize {
        self.right(question).length
    }

    /// A few wrong answers on which it is tried before it is tried on all, as are a thousand others of its way: those whose ways are
    /// short, and come by all places.
    pub fn tried_on(&self, evidence: &Evidence<'_>, share: f64) -> Vec<usize> {
        let wrong = evidence.items[..evidence.wrong].iter();
        let serve: Vec<_> = wrong
            .map(|item| self.right(&item.question).serves())
            .collect();
        evidence.few(share, |i| serve[i])
    }

    fn right(&self, question: &[f64]) -> Walked {
        let mut way = Way::default();
        (self.explainer.work)(self.way, question, &mut way);
        way.end()
    }
}

/// A number of its own for each slip.
fn id(slip: &Slip) -> u64 {
    let mut hasher = DefaultHasher::new();
    format!("{slip:?}").hash(&mut hasher);
    hasher.finish()
}

/// What slips answer.
#[derive(Default)]
pub struct Tried {
    /// By the way, the slip and the case.
    answers: HashMap<(usize, u64, usize), Option<Vec<f64>>>,
    /// The number of steps of all the ways that were gone for these.
    pub steps: usize,
    /// Whether they were found to be too many.
    is_over: bool,
}

impl Tried {
    /// Counts the steps: if they are too many, no more are gone. Returns how many slips may be tried until they are counted again.
    fn count(&mut self) -> usize {
        self.is_over = self.steps > STEPS;
        let of_one = self.steps.div_ceil(self.answers.len().max(1)).max(1);
        let left = STEPS.saturating_sub(self.steps);
        (left / (SHARE * of_one)).clamp(FEWEST, MOST)
    }
}

/// The fewest slips that are tried before steps are counted again …
const FEWEST: usize = 8;

/// … and the most.
const MOST: usize = 512;

/// Between two counts, slips go one in this number of the steps that are left, if each has one answer of mean length. Most have a few.
const SHARE: usize = 32;

/// What a function makes of each slip, in their order, on all cores. Steps are counted between blocks of slips, so that it does not hang
/// on the order in which these are tried which are the last.
pub fn each_slip<R: Send + Sync>(
    evidence: &Evidence<'_>,
    slips: &[Slipped],
    make: impl Fn(&Slipped) -> R + Sync,
) -> Vec<R> {
    let mut made = Vec::new();
    let mut rest = slips;
    while !rest.is_empty() {
        let size = lock(&evidence.slips).count();
        let (block, others) = rest.split_at(size.min(rest.len()));
        made.extend(each(block, &make));
        rest = others;
    }
    made
}

/// Steps and decisions that are gone with slips in one diagnosis: of a long way only the slips that are most common are tried.
pub const STEPS: usize = 30_000_000;

/// The rank of the first change of a value that is no common one: takes 0, 1, twice or half of it.
const RARE: u32 = 10;

/// Whether most right answers are those of one of the ways that are known.
pub fn goes_a_known_way(evidence: &Evidence<'_>) -> bool {
    let goes = |explainer: &Explainer, number: usize| {
        evidence.goes_as(|item| {
            attempt(|| (explainer.work)(number, &item.question, &mut Way::default()))
        })
    };
    let explainer = find(evidence.examiner.asked().name);
    explainer.is_some_and(|of| (0..of.ways).any(|number| goes(of, number)))
}

/// Every way to the answers with every slip that its steps allow in these questions.
pub fn slipped(evidence: &Evidence<'_>) -> Vec<Slipped> {
    let Some(explainer) = find(evidence.examiner.asked().name) else {
        return Vec::new();
    };
    let of_way = |way| possible::slips(explainer, way, evidence);
    (0..explainer.ways).flat_map(of_way).collect()
}
