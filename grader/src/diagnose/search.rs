//! Trying all explanations by one mistake.

use super::component;
use super::evidence::{Evidence, Scope};
use super::fit::{self, Answers, Explanation};
use super::found::Found;
use super::misread::{Misreading, bounded, times};
use super::pairs::{both, composed, made_upon, pairs};
use super::regime::{self, Regime};
use super::slips::{Slipped, each_slip, fitted, goes_a_known_way, slipped};
use super::special;
use super::{Diagnosis, MOST};
use crate::attempt::attempt;
use crate::each::found_of_each;
use raybook_workbook::exercise::Asked;
use std::collections::BTreeMap;

/// The explanation that agrees best with the evidence.
pub fn search(evidence: &Evidence<'_>, readings: &[Misreading]) -> Option<Found> {
    let mut found = Vec::new();
    plain(evidence, readings, MOST, &mut found);
    if !found.iter().any(Found::is_complete) && evidence.scope != Scope::Shape {
        pairs(evidence, readings, &mut found);
        composed(evidence, &mut found);
        made_upon(evidence, &mut found);
        // One slip that explains all but a few answers, which rounding decides, is simpler than two.
        if !found.iter().any(Found::is_nearly_the_one) {
            both(evidence, readings, &mut found);
        }
    }
    found.retain(Found::holds);
    best(without_trifles(found))
}

/// The explanations without pairs of which one mistake alone gives nearly all answers, if the other is a guess: a guess gives what rounding
/// decides by chance, and is told as a mistake that nobody made.
fn without_trifles(mut found: Vec<Found>) -> Vec<Found> {
    let alone = found.iter().filter(|one| one.then.is_none());
    let alone = alone.filter(|one| one.is_own() && one.score.contradicted == 0);
    let alone: Vec<_> = alone
        .map(|one| (one.name.clone(), one.score.explained))
        .collect();
    found.retain(|pair| {
        let Some((then, _)) = &pair.then else {
            return true;
        };
        let is_half = |name: &String| name == &pair.name || name == then;
        let gives_nearly_all = |explained: usize| {
            FEW_LEFT * pair.score.explained.saturating_sub(explained) <= explained
        };
        pair.is_of_own()
            || !alone
                .iter()
                .any(|(name, explained)| is_half(name) && gives_nearly_all(*explained))
    });
    found
}

/// One mistake gives nearly all answers of a pair if it gives this many for each one that it leaves.
const FEW_LEFT: usize = 5;

/// The best: of the exercise's own mistakes that agree as well as each other, the one that is nearest to all answers. Of those that yes
/// and no cannot tell apart, the second is its rival; of estimates, which scatter, a factor is, too, and what nearly explains them; and so
/// is of other explanations the second that is as common and agrees as well.
fn best(mut found: Vec<Found>) -> Option<Found> {
    found.sort_by_key(Found::key);
    let mut found = found.into_iter();
    let mut best = found.next()?;
    let as_good = |one: &Found| {
        if best.is_own() {
            let is_rough = best.score.is_rough;
            let is_vague = best.is_categorical() && one.is_own() || is_rough;
            let is_near = one.score.missed == 0 && one.is_nearly_complete();
            let is_as_exact = one.ties <= best.ties;
            is_vague && is_as_exact && (one.is_complete() || is_rough && is_near)
        } else {
            one.key() == best.key() && one.name != best.name
        }
    };
    // Of two mistakes at once, half of another pair tells nothing.
    if best.is_complete() && best.then.is_none() {
        let rival = found.find(as_good);
        best.rival = rival.map(|rival| (rival.name, rival.hint));
    }
    Some(best)
}

/// The exercise's own mistakes that give this share of the wrong answers.
fn own(evidence: &Evidence<'_>, share: f64, found: &mut Vec<Found>) {
    let examiner = evidence.examiner;
    let mistakes: Vec<_> = examiner.mistakes().into_iter().enumerate().collect();
    found.extend(found_of_each(&mistakes, |&(i, (name, hint))| {
        let one = Explanation {
            name: name.to_owned(),
            hint: hint.to_owned(),
            rank: 0,
            fitted: 0,
            answers: Vec::new(),
        };
        let mut one = consider(evidence, share, one, &|k| evidence.mistaken(i, k))?;
        let answer = |question: &[f64]| attempt(|| examiner.mistake_answers(i, question))?;
        one.decide_ties(evidence, &answer);
        Some(one)
    }));
}

/// The own mistake that gives nearly all answers. In a few cases rounding decides what is answered: a ray in a plane, a box that is only
/// touched.
pub fn nearly(evidence: &Evidence<'_>) -> Option<Found> {
    let mut found = Vec::new();
    own(evidence, MOST, &mut found);
    found.retain(Found::is_nearly_complete);
    best(found)
}

/// The explanation that gives all wrong answers to the last digits, although right answers contradict it: a mistake in one branch only.
pub fn partly(evidence: &Evidence<'_>, readings: &[Misreading]) -> Option<Found> {
    let mut found = Vec::new();
    plain(evidence, readings, 1.0, &mut found);
    found.retain(Found::is_partly);
    best(found)
}

/// The explanation that gives all wrong answers to the last digits, and in words what the questions of these have in common, where it
/// contradicts no right answer: it may where the question is another.
pub fn limited(evidence: &Evidence<'_>, readings: &[Misreading]) -> Option<(Found, String)> {
    if evidence.wrong < ENOUGH {
        return None;
    }
    let mut found = Vec::new();
    plain(evidence, readings, 1.0, &mut found);
    limited_among(evidence, found)
}

/// The same of these explanations.
fn limited_among(evidence: &Evidence<'_>, mut found: Vec<Found>) -> Option<(Found, String)> {
    found.retain(Found::is_partly);
    if found.is_empty() || evidence.wrong < ENOUGH {
        return None;
    }
    let regimes = regime::of_wrong(evidence);
    found.sort_by_key(Found::key);
    let mut pairs = found.into_iter().filter_map(|mut one| {
        let holds = |regime: &&Regime| {
            let predict = |k: usize| {
                if regime.holds[k] {
                    one.answers[k].clone()
                } else {
                    Some(evidence.items[k].golden().to_vec())
                }
            };
            let score = evidence.score(1.0, predict);
            score.is_some_and(|score| score.contradicted == 0)
        };
        let words = regimes.iter().find(holds)?.words.clone();
        one.score.contradicted = 0;
        Some((one, words))
    });
    pairs.next()
}

/// Of fewer wrong answers too much is in common.
const ENOUGH: usize = 3;

/// All explanations by one mistake that give this share of the wrong answers.
pub fn plain(evidence: &Evidence<'_>, readings: &[Misreading], share: f64, found: &mut Vec<Found>) {
    own(evidence, share, found);
    let known = |one: Explanation| {
        let answers = one.answers.clone();
        consider(evidence, share, one, &|k| answers[k].clone())
    };
    if evidence.is_rough() {
        let factors = fit::factors(evidence, &golden(evidence));
        found.extend(factors.into_iter().filter_map(known));
    }
    if share >= MOST && found.iter().any(Found::is_exact) {
        return; // a mistake of its own is told before any other
    }
    let golden = golden(evidence);
    let mut made = special::explanations(evidence, &golden);
    made.extend(fit::explanations(evidence, &golden, true));
    found.extend(made.into_iter().filter_map(known));
    found.extend(found_of_each(&component::all(evidence), |one| {
        let answer = |k: usize| one.answer(evidence, k);
        consider(evidence, share, one.explanation(), &answer)
    }));
    let misread = |reading: &Misreading| {
        let answer = |k: usize| misread(evidence, reading, k);
        consider(evidence, share, by_reading(reading), &answer)
    };
    found.extend(found_of_each(readings, misread));
    if evidence.is_judged() && !found.iter().any(Found::is_exact) {
        by_slips(evidence, share, slipped(evidence), found);
    }
    if !found.iter().any(Found::is_exact) {
        let undone = fit::undone(evidence, &golden);
        found.extend(undone.into_iter().filter_map(known));
    }
    let is_whole = evidence.is_judged() && evidence.scope == Scope::Whole && share >= MOST;
    let is_quick = evidence.examiner.limits().effort <= 1;
    let asked = evidence.examiner.asked().question;
    if is_whole && is_quick && !found.iter().any(Found::is_exact) {
        found.extend(found_of_each(&bounded(asked), misread));
    }
    let is_fit = is_whole && evidence.tells_much();
    if is_fit && !found.iter().any(Found::is_exact) {
        found.extend(found_of_each(&times(asked), |reading| {
            let answer = |by: f64, k: usize| self::misread(evidence, &reading(by), k);
            let by = fit::factor::factor(evidence, &answer)?;
            misread(&reading(by))
        }));
        by_slips(evidence, share, fitted(evidence), found);
    }
}

/// The explanation by a question that was misread.
fn by_reading(reading: &Misreading) -> Explanation {
    Explanation {
        name: reading.name.clone(),
        hint: reading.hint.clone(),
        rank: reading.rank,
        fitted: 0,
        answers: Vec::new(),
    }
}

/// All explanations by a step that goes wrong.
fn by_slips(evidence: &Evidence<'_>, share: f64, mut slips: Vec<Slipped>, found: &mut Vec<Found>) {
    slips.sort_by_key(|slip| slip.rank);
    let mut few_of_ways = BTreeMap::new();
    for slip in &slips {
        let few = few_of_ways.entry(slip.way);
        few.or_insert_with(|| slip.tried_on(evidence, share));
    }
    let considered = each_slip(evidence, &slips, |slip| {
        let answer = |k: usize| {
            let made = slip.answer_to(evidence, k)?;
            Some(evidence.normalised(made))
        };
        let one = Explanation {
            name: slip.name.clone(),
            hint: slip.hint.clone(),
            rank: slip.rank,
            fitted: 0,
            answers: Vec::new(),
        };
        let few = &few_of_ways[&slip.way];
        let mut one = consider_after(evidence, few, share, one, &answer)?;
        let beside = |k: usize| slip.answer_beside(&evidence.items[k].question);
        let beside = evidence.score(share, beside);
        let is_vague = beside.is_some_and(|beside| beside.sharp >= one.score.sharp);
        one.score.is_doubtful |= slip.is_doubtful() || is_vague;
        Some(one)
    });
    found.extend(considered.into_iter().flatten());
}

/// The step that goes wrong where many answers are right, as of a tree: told if right answers are those of the same way. Few decisions
/// make a structure, and several slips the same one, so it is never certain.
pub fn slip_of_structure(evidence: &Evidence<'_>) -> Option<Diagnosis> {
    // Where none is right, it shows in the wrong ones: to the last digits they are those of the slip.
    if evidence.is_judged() {
        return None;
    }
    let short = evidence.of_short()?;
    let is_known = evidence.wrong == evidence.items.len()
        || evidence.goes_the_same_way()
        || goes_a_known_way(&short);
    let mut found = Vec::new();
    by_slips(&short, MOST, slipped(&short), &mut found);
    // Or the right ones show the slip, too, and cost little more.
    found.retain(|one| is_known || 2 * one.score.close > short.items.len());
    let (whole, in_some): (Vec<_>, Vec<_>) = found
        .into_iter()
        .partition(|one| one.score.contradicted == 0);
    let told = if let Some(found) = best(whole) {
        found.told(&short)
    } else {
        let (found, words) = limited_among(&short, in_some)?;
        found.told_only(&short, Some(&format!("where {words}")))
    };
    Some(Diagnosis {
        certain: false,
        ..told
    })
}

/// The right answers.
pub fn golden(evidence: &Evidence<'_>) -> Answers {
    evidence
        .items
        .iter()
        .map(|item| Some(item.golden().to_vec()))
        .collect()
}

/// The right answer to an item's question, misread.
pub fn misread(evidence: &Evidence<'_>, reading: &Misreading, item: usize) -> Option<Vec<f64>> {
    let (examiner, item) = (evidence.examiner, &evidence.items[item]);
    match reading.read(examiner.asked().question, &item.question) {
        Some(question) => attempt(|| examiner.right(&question)),
        None => Some(item.golden().to_vec()),
    }
}

/// The right answer to a question that may make no sense; none if the library panics.
pub fn called(asked: &Asked, question: &[f64]) -> Option<Vec<f64>> {
    attempt(|| (asked.call)(question))
}

/// An explanation that gives this share of the wrong answers.
fn consider(
    evidence: &Evidence<'_>,
    share: f64,
    one: Explanation,
    answer: &dyn Fn(usize) -> Option<Vec<f64>>,
) -> Option<Found> {
    consider_after(evidence, &evidence.few(share, |_| ()), share, one, answer)
}

/// The same, given up if it gives none of a few wrong answers.
fn consider_after(
    evidence: &Evidence<'_>,
    few: &[usize],
    share: f64,
    one: Explanation,
    answer: &dyn Fn(usize) -> Option<Vec<f64>>,
) -> Option<Found> {
    let score = evidence.score_after(few, share, answer)?;
    let answers = if one.answers.is_empty() {
        (0..evidence.items.len()).map(answer).collect()
    } else {
        one.answers
    };
    Some(Found {
        name: one.name,
        hint: one.hint,
        then: None,
        rival: None,
        rank: one.rank,
        fitted: one.fitted,
        score,
        answers,
        ties: 0,
    })
}
