//! The rest: of two mistakes in one function the first explains most of the wrong answers, and both together explain the others.

use super::MOST;
use super::evidence::Evidence;
use super::fit::{self, Answers};
use super::found::Found;
use super::misread::Misreading;
use super::pairs::{TOGETHER, of_two, pair};
use super::search::{golden, misread};
use super::slips::{Slipped, each_slip, fitted, slipped};
use super::special;

/// The rank of a second mistake: what is told of both is never certain.
const RANK: u32 = 44;

/// Of several slips that are the first mistake, these are tried with others.
const SLIPS: usize = 3;

/// A mistake that may have been made besides the first, with its answers, one for each item.
struct Other {
    name: String,
    hint: String,
    rank: u32,
    answers: Answers,
}

/// The first mistake and a second one, which explain all answers together; none if the first explains less than half of the wrong ones.
pub fn explained(evidence: &Evidence<'_>, readings: &[Misreading], first: &Found) -> Option<Found> {
    let is_left = |k: &usize| {
        let answer = first.answers[*k].as_ref();
        !answer.is_some_and(|answer| evidence.explains(*k, answer))
    };
    let rest: Vec<_> = (0..evidence.wrong).filter(is_left).collect();
    if rest.is_empty() || 2 * rest.len() > evidence.wrong {
        return None;
    }
    let mut found = beside(evidence, readings, first, &rest);
    if found.is_empty() && evidence.is_judged() {
        found = on_one_way(evidence, first, &rest);
    }
    found.into_iter().min_by_key(Found::key)
}

/// Both together, if they explain all.
fn both(evidence: &Evidence<'_>, first: &Found, other: Other, rest: &[usize]) -> Option<Found> {
    let explains = |k: &usize| {
        let answer = other.answers[*k].as_ref();
        answer.is_some_and(|answer| evidence.explains(*k, answer))
    };
    if !rest.iter().all(explains) {
        return None;
    }
    let score = evidence.score(MOST, |k| other.answers[k].clone())?;
    let names = [(&*first.name, &*first.hint), (&*other.name, &*other.hint)];
    let rank = RANK + other.rank;
    let found = pair(names, rank, first.fitted, score, other.answers);
    found.is_complete().then_some(found)
}

/// The first mistake with one of the exercise's own, or with a question that was misread: each changes a summand, a factor or a branch of its
/// own, or the first is made of what the other answers.
fn beside(
    evidence: &Evidence<'_>,
    readings: &[Misreading],
    first: &Found,
    rest: &[usize],
) -> Vec<Found> {
    let items = &evidence.items;
    let right = golden(evidence);
    let is_made = |one: &fit::Explanation| one.name == first.name;
    let made_of = |base: &Answers| {
        let mut made = special::explanations(evidence, base);
        made.extend(fit::explanations(evidence, base, true));
        made.retain(is_made);
        made
    };
    let is_fit = !first.is_own() && !made_of(&right).is_empty();
    let mut found = Vec::new();
    for other in others(evidence, readings, rest) {
        let mut made: Vec<Answers> = Vec::new();
        for together in TOGETHER {
            let of_item = |k: usize| {
                let (one, other) = (first.answers[k].as_ref()?, other.answers[k].as_ref()?);
                of_two(items[k].golden(), one, other, together)
            };
            made.push((0..items.len()).map(of_item).collect());
        }
        if is_fit {
            let again = made_of(&other.answers);
            made.extend(again.into_iter().map(|one| one.answers));
        }
        let pairs = made.into_iter().filter_map(|answers| {
            let (name, hint, rank) = (other.name.clone(), other.hint.clone(), other.rank);
            let other = Other {
                name,
                hint,
                rank,
                answers,
            };
            both(evidence, first, other, rest)
        });
        found.extend(pairs);
    }
    found
}

/// The mistakes that show in all answers of the rest.
fn others(evidence: &Evidence<'_>, readings: &[Misreading], rest: &[usize]) -> Vec<Other> {
    let examiner = evidence.examiner;
    let n = evidence.items.len();
    let right = |k: usize| evidence.items[k].golden();
    let mut others = Vec::new();
    let mut consider =
        |name: &str, hint: &str, rank, answer: &dyn Fn(usize) -> Option<Vec<f64>>| {
            let answer =
                |k: usize| Some(evidence.canonical(&evidence.items[k].question, &answer(k)?));
            let differs = |k: &usize| answer(*k).is_some_and(|answer| answer != right(*k));
            if rest.iter().all(differs) {
                let [name, hint] = [name, hint].map(str::to_owned);
                let answers = (0..n).map(answer).collect();
                others.push(Other {
                    name,
                    hint,
                    rank,
                    answers,
                });
            }
        };
    for (i, (name, hint)) in examiner.mistakes().into_iter().enumerate() {
        consider(name, hint, 0, &|k| evidence.mistaken(i, k));
    }
    for reading in readings {
        let answer = |k: usize| misread(evidence, reading, k);
        consider(&reading.name, &reading.hint, reading.rank, &answer);
    }
    others
}

/// The first mistake and another slip on the way to an answer, where the first is a slip on this way.
fn on_one_way(evidence: &Evidence<'_>, first: &Found, rest: &[usize]) -> Vec<Found> {
    let mut slips = slipped(evidence);
    slips.extend(fitted(evidence));
    let explained: Vec<_> = (0..evidence.wrong).filter(|k| !rest.contains(k)).collect();
    let is_first = |slip: &Slipped| {
        let agrees = |k: &usize| {
            let answer = slip.answer_to(evidence, *k);
            answer.is_some_and(|answer| evidence.explains(*k, &answer))
        };
        slip.name == first.name || explained.iter().all(agrees)
    };
    let mut found = Vec::new();
    let are_first = each_slip(evidence, &slips, is_first);
    let firsts = slips
        .iter()
        .zip(are_first)
        .filter(|(_, is_first)| *is_first);
    for (one, _) in firsts.take(SLIPS) {
        for other in slips.iter().filter(|other| one.goes_with(other)) {
            let of_item = |k: usize| one.answer_with(other, &evidence.items[k].question);
            let explains =
                |k: &usize| of_item(*k).is_some_and(|answer| evidence.explains(*k, &answer));
            if rest.iter().all(explains) {
                let other = Other {
                    name: other.name.clone(),
                    hint: other.hint.clone(),
                    rank: other.rank,
                    answers: (0..evidence.items.len()).map(of_item).collect(),
                };
                found.extend(both(evidence, first, other, rest));
            }
        }
    }
    found
}
