//! Questions that rounding decides: a ray between two cells, a number that is to be rounded and is just between two. Who makes a mistake
//! and calculates in another order answers there what the mistake answers to a question next to it.

use super::evidence::Evidence;
use super::fit::Answers;
use super::search::called;
use crate::examine::{Examiner, visible_rng};
use crate::layout::{Leaf, layout, parts};
use rand::RngExt;
use raybook::math::pcg::Pcg;
use raybook_workbook::kind::Kind;

/// Questions next to one that are tried: of several numbers that rounding decides, each way of deciding should come.
const TRIES: usize = 16;

/// Answers that a mistake does not give are those of ties only if it gives this many others for each.
const FEW: usize = 6;

/// How often a field is moved with others: a ray that is turned leaves the plane between two cells, which it need not if only its origin is
/// moved.
const SOME: f64 = 0.5;

/// Tries of moving a question's last digits, to see whether the right answer stays right.
const BESIDE: usize = 4;

/// By how much a question's numbers are moved at most, as a share of the largest.
const LAST_DIGITS: f64 = 1e-6;

/// Decides ties among `answers`, which are those of a mistake, as the student's rounding does; returns how many there are.
///
/// There the mistake's answer becomes the one that it gives next to the question and that is the student's; and where it gives several
/// answers next to it, of which none is, any is as good as the student's. What explains all answers without such leave comes first.
pub fn decide(
    evidence: &Evidence<'_>,
    answers: &mut Answers,
    answer: &dyn Fn(&[f64]) -> Option<Vec<f64>>,
) -> usize {
    let gives = |k: usize, answer: &Option<Vec<f64>>| {
        let item = &evidence.items[k];
        let gives = |answer: &Vec<f64>| {
            evidence.explains(k, answer) || item.right && evidence.is_right(item, answer)
        };
        answer.as_ref().is_some_and(gives)
    };
    let all = 0..evidence.items.len();
    let other: Vec<_> = all.filter(|k| !gives(*k, &answers[*k])).collect();
    let are_few = (FEW + 1) * other.len() <= evidence.items.len();
    if !are_few || !evidence.is_judged() || evidence.is_rough() {
        return 0;
    }
    let rng = &mut visible_rng(&format!("{}, ties", evidence.examiner.name()));
    let mut ties = 0;
    for k in other {
        let item = &evidence.items[k];
        let next_to = |_| beside(evidence.examiner, &item.question, SOME, rng);
        let next_to: Vec<_> = (0..TRIES).map(next_to).collect();
        // Where rounding would make a right answer wrong, numbers are chosen so that it decides nothing.
        let right = |question: &[f64]| called(evidence.examiner.asked(), question);
        if !stays(evidence.examiner, &item.question, &next_to, &right) {
            continue;
        }
        let tries: Vec<_> = next_to.iter().map(|next| answer(next)).collect();
        let tie = match tries.iter().position(|tie| gives(k, tie)) {
            Some(at) => tries[at].clone(),
            None if is_alike(&item.raw, &tries) && evidence.differ(item, &tries) => {
                Some(item.raw.clone())
            }
            None => continue,
        };
        answers[k] = tie;
        ties += 1;
    }
    ties
}

/// A question whose numbers, but for whole and infinite ones, differ from those of this one in their last digits: each field with this
/// probability.
pub fn beside(
    examiner: &dyn Examiner,
    question: &[f64],
    probability: f64,
    rng: &mut Pcg,
) -> Vec<f64> {
    // Nor does a whole number tell how large the others are: a seed may be four billion.
    let leaves = leaves(examiner, question, |kind| !matches!(kind, Kind::Whole));
    let sizes = leaves.iter().flat_map(|leaf| &question[leaf.range()]);
    let sizes = sizes.filter(|v| v.is_finite());
    let size = sizes.fold(0.0, |size: f64, v| size.max(v.abs()));
    let mut moved = question.to_vec();
    for leaf in leaves {
        if rng.random_bool(probability) {
            for v in &mut moved[leaf.range()] {
                *v = f64::from((*v + size * LAST_DIGITS * rng.random_range(-1.0..1.0)) as f32);
            }
        }
    }
    moved
}

/// Where the numbers of fields of some kinds are in a question.
pub fn leaves(examiner: &dyn Examiner, question: &[f64], is_one: fn(&Kind) -> bool) -> Vec<Leaf> {
    let kind = examiner.asked().question;
    let kinds: Vec<_> = parts(kind, "").into_iter().map(|part| part.kind).collect();
    let leaves = layout(kind, question).leaves.into_iter();
    leaves.filter(|leaf| is_one(kinds[leaf.part])).collect()
}

/// Whether an answer has as many numbers as one of these: what rounding decides is mostly a number, not whether there is an answer.
fn is_alike(answer: &[f64], others: &[Option<Vec<f64>>]) -> bool {
    let mut others = others.iter().flatten();
    others.any(|other| other.len() == answer.len())
}

/// Whether an `answer` stays the same to its judge if the question's round numbers, too, differ in their last digits: not where a ray runs
/// between two cells, and rounding decides through which of them it goes.
pub fn is_settled(
    examiner: &dyn Examiner,
    question: &[f64],
    answer: &dyn Fn(&[f64]) -> Option<Vec<f64>>,
    rng: &mut Pcg,
) -> bool {
    let next_to = |_| beside(examiner, question, 1.0, rng);
    let next_to: Vec<_> = (0..BESIDE).map(next_to).collect();
    stays(examiner, question, &next_to, answer)
}

/// Whether the answers to questions next to one are answers to that one, too.
fn stays(
    examiner: &dyn Examiner,
    question: &[f64],
    next_to: &[Vec<f64>],
    answer: &dyn Fn(&[f64]) -> Option<Vec<f64>>,
) -> bool {
    let here = answer(question);
    next_to.iter().all(|next| {
        let both = here.as_ref().zip(answer(next));
        both.is_some_and(|(here, next)| examiner.compare(question, here, &next).is_ok())
    })
}
