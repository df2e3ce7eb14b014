//! The further questions of a trial: fair ones, on which the first suspect shows, and which tell it from the others.

use super::suspects::{HALF, Suspect};
use super::{ENOUGH, same};
use crate::diagnose::evidence::Evidence;
use crate::diagnose::search::called;
use crate::diagnose::ties::{is_settled, leaves};
use crate::examine::{Case, Examiner};
use crate::stable::is_stable;
use rand::RngExt;
use raybook::math::pcg::Pcg;
use raybook_workbook::kind::Kind;
use std::collections::BTreeSet;

/// Questions on which the first suspect shows, at most.
const SHOWN: usize = 32;

/// Questions on which it shows that are looked for, where answers are estimates, which scatter.
const ENOUGH_ROUGH: usize = 24;

/// Questions on which it does not show.
const HIDDEN: usize = 8;

/// Questions after which none is looked for any longer on which it does not show: it shows in nearly all.
const ALL_SHOW: usize = 100;

/// Questions that are looked through, divided by the effort of an answer, …
const DRAWN: usize = 2000;

/// … and the fewest.
const FEWEST: usize = 40;

/// The questions that were found.
struct Questions {
    cases: Vec<Case>,
    /// Those on which the first suspect shows, and the fewest that are looked for.
    shown: usize,
    least: usize,
    /// Those on which it does not show.
    hidden: usize,
    /// Those that tell it from each other suspect.
    told_from: Vec<usize>,
}

impl Questions {
    fn are_enough(&self, drawn: usize) -> bool {
        let are_told = self.told_from.iter().all(|count| *count >= ENOUGH) || self.shown == SHOWN;
        let are_hidden = self.hidden == HIDDEN || drawn >= ALL_SHOW;
        self.shown >= self.least && are_told && are_hidden
    }

    /// Whether one more is wanted on which the first suspect shows, or does not.
    fn want(&self, shows: bool) -> bool {
        if shows {
            self.shown < SHOWN
        } else {
            self.hidden < HIDDEN
        }
    }

    /// Whether one more is wanted on which it shows, and which tells it from these of the others.
    fn want_from(&self, differ: &[bool]) -> bool {
        let mut each = self.told_from.iter().zip(differ);
        self.shown < self.least || each.any(|(count, differs)| *differs && *count < ENOUGH)
    }

    fn add(&mut self, case: Case, shows: bool, differ: &[bool]) {
        if shows {
            self.shown += 1;
            for (count, differs) in self.told_from.iter_mut().zip(differ) {
                *count += usize::from(*differs);
            }
        } else {
            self.hidden += 1;
        }
        self.cases.push(case);
    }
}

/// Fair questions on which the first suspect shows, and which tell it from the others, and some on which it does not show: random ones,
/// and such as are near to those whose wrong answers it explains, or are these on another scale.
pub fn questions(evidence: &Evidence<'_>, suspects: &[Suspect<'_>], rng: &mut Pcg) -> Vec<Case> {
    let Some((first, others)) = suspects.split_first() else {
        return Vec::new();
    };
    let examiner = evidence.examiner;
    // On a small scale there may be a million points, which tell no more than a hundred.
    let longest = evidence.items.iter().map(|item| item.got.len()).max();
    let answered = |question: &[f64]| {
        let answer = (first.answer)(question);
        answer.filter(|answer| Some(answer.len()) <= longest)
    };
    let explained = explained(evidence, first);
    let mut found = Questions {
        cases: Vec::new(),
        shown: 0,
        least: if evidence.is_rough() {
            ENOUGH_ROUGH
        } else {
            SHOWN / 2
        },
        hidden: 0,
        told_from: vec![0; others.len()],
    };
    for i in 0..(DRAWN / examiner.limits().effort).max(FEWEST) {
        if found.are_enough(i) {
            break;
        }
        // On another scale, one question is hardly more than itself: guesses, of which there are many, need other questions.
        let is_scaled = i % 4 == 3 && !first.is_guess && !explained.is_empty();
        let question = match explained.get(i / 4 % explained.len().max(1)) {
            Some(wrong) if is_scaled => {
                let whole = scaled(examiner, wrong, 1.0, rng);
                let answer = answered(&whole).filter(|_| examiner.is_sound(&whole));
                if answer.is_some_and(|answer| !examiner.is_right(&whole, &answer)) {
                    whole
                } else {
                    scaled(examiner, wrong, HALF, rng)
                }
            }
            Some(wrong) if i % 2 == 1 => near(wrong, rng),
            _ => examiner.random(rng),
        };
        if !examiner.is_sound(&question) {
            continue;
        }
        let Some(answer) = answered(&question) else {
            continue;
        };
        let shows = !examiner.is_right(&question, &answer);
        if !found.want(shows) {
            continue;
        }
        let differs =
            |other: &Suspect<'_>| !same((other.answer)(&question).as_deref(), Some(&answer));
        let differ: Vec<_> = others.iter().map(|other| shows && differs(other)).collect();
        if shows && !found.want_from(&differ)
            || !is_fair(examiner, &question, first, is_scaled, rng)
        {
            continue;
        }
        let Ok(case) = examiner.case("a further question", &question) else {
            continue;
        };
        let mut cases = found.cases.iter();
        if !is_scaled || cases.all(|other| other.question != case.question) {
            found.add(case, shows, &differ);
        }
    }
    found.cases
}

/// The questions whose wrong answers are as this suspect says.
fn explained<'e>(evidence: &'e Evidence<'_>, suspect: &Suspect<'_>) -> Vec<&'e [f64]> {
    let wrong = evidence.items[..evidence.wrong].iter().enumerate();
    let explained = wrong.filter(|(k, item)| {
        let answer = (suspect.answer)(&item.question);
        answer.is_some_and(|answer| evidence.explains(*k, &answer))
    });
    explained.map(|(_, item)| &*item.question).collect()
}

/// Whether rounding decides nothing in a question. What it decides, it decides in a scaled question as in the one that was asked; not always as
/// its judge does. Of two mistakes it decides more than of one.
fn is_fair(
    examiner: &dyn Examiner,
    question: &[f64],
    suspect: &Suspect<'_>,
    is_scaled: bool,
    rng: &mut Pcg,
) -> bool {
    let right = |question: &[f64]| called(examiner.asked(), question);
    if is_scaled {
        return right(question).is_some_and(|right| examiner.is_right(question, &right));
    }
    is_settled(examiner, question, &right, rng)
        && (!suspect.is_two() || is_settled(examiner, question, &*suspect.answer, rng))
        && is_stable(examiner, question, rng)
}

/// A question whose numbers are a fifth larger or smaller at most, but for whole ones.
fn near(question: &[f64], rng: &mut Pcg) -> Vec<f64> {
    let moved = question.iter().map(|v| {
        if v.is_finite() && v.fract() != 0.0 {
            f64::from((v * rng.random_range(0.8..1.2)) as f32)
        } else {
            *v
        }
    });
    moved.collect()
}

/// A question whose lengths, and all other numbers that are neither whole nor of a direction, are a power of two times as large, those of each
/// field with this probability: no digit changes, and what is equal stays equal, such as a discriminant and 0. What a ratio is compared with
/// must not grow with its two numbers, and so some fields stay as they are where all together show nothing.
fn scaled(examiner: &dyn Examiner, question: &[f64], probability: f64, rng: &mut Pcg) -> Vec<f64> {
    /// The largest power, and the smallest.
    const POWER: i32 = 5;
    let factor = f64::from(rng.random_range(-POWER..=POWER)).exp2();
    let is_scaled = |kind: &Kind| !matches!(kind, Kind::Whole | Kind::Direction);
    let leaves = leaves(examiner, question, is_scaled);
    let mut fields: BTreeSet<usize> = leaves.iter().map(|leaf| leaf.part).collect();
    fields.retain(|_| rng.random_bool(probability));
    let mut scaled = question.to_vec();
    for leaf in leaves.iter().filter(|leaf| fields.contains(&leaf.part)) {
        scaled[leaf.range()].iter_mut().for_each(|v| *v *= factor);
    }
    scaled
}
