//! Several mistakes in one function, each of which shows in other cases: who begins makes two at once.

use super::evidence::{Evidence, Score};
use super::misread::Misreading;
use super::search::misread;
use super::{Beside, COMMON, Diagnosis};
use crate::each::found_of_each;

/// Mistakes that are told at once.
const SEVERAL: usize = 3;

/// Each must give this number of the wrong answers that those before do not give: one may fit by chance.
const ALONE: usize = 2;

/// The first is contradicted by one right answer at most for this number of wrong ones. The others may be hidden by it more often.
const HIDDEN: usize = 4;

/// Mistakes that together give wrong answers.
pub struct Cover {
    chosen: Vec<One>,
    /// How many wrong answers they give.
    pub explained: usize,
    wrong: usize,
}

/// A mistake, and what of the answers is as it says.
struct One {
    name: String,
    hint: String,
    /// 0 for one of the exercise's own.
    rank: u32,
    score: Score,
    /// Of each wrong answer, whether the mistake gives it.
    gives: Vec<bool>,
    /// Of each wrong answer, whether the mistake's own answer is wrong, too.
    shows: Vec<bool>,
    /// The first case that it gives.
    shown: Option<usize>,
}

impl One {
    /// Whether it hides nothing of another: where the other gives the answers, this one gives them, too, or does not show.
    fn is_beside(&self, other: &Self) -> bool {
        let mut each = other.gives.iter().zip(self.gives.iter().zip(&self.shows));
        each.all(|(other, (gives, shows))| !other || *gives || !shows)
    }
}

impl Cover {
    /// Whether they are several, and give all wrong answers.
    pub fn is_whole(&self) -> bool {
        self.chosen.len() > 1 && self.explained == self.wrong
    }

    /// Whether they are the exercise's own.
    pub fn is_own(&self) -> bool {
        self.chosen.iter().all(|one| one.rank == 0)
    }

    /// Whether of each two one may hide the other, but not each the other: who makes both does one before the other.
    pub fn go_together(&self) -> bool {
        let pairs = |(i, one): (usize, &One)| {
            let mut before = self.chosen[..i].iter();
            before.all(|other| one.is_beside(other) || other.is_beside(one))
        };
        self.chosen.iter().enumerate().all(pairs)
    }

    /// Certain, if they are the exercise's own and give all wrong answers, nothing contradicts them, and the answers say more than yes
    /// or no.
    pub fn told(&self) -> Option<Diagnosis> {
        let clear = |one: &One| {
            let is_doubtful = one.score.is_doubtful || one.rank > 0;
            one.score.contradicted == 0 && one.score.tells >= 1.0 && !is_doubtful
        };
        let certain = self.is_whole() && self.go_together() && self.chosen.iter().all(clear);
        let told = |one: &One| Diagnosis {
            name: one.name.clone(),
            hint: one.hint.clone(),
            part: None,
            certain,
            explained: one.score.explained,
            wrong: self.wrong,
            further: 0,
            shown: one.shown,
            beside: Beside::Apart,
            also: Vec::new(),
        };
        let mut all = self.chosen.iter().map(told);
        let first = all.next()?;
        Some(Diagnosis {
            also: all.collect(),
            ..first
        })
    }
}

/// The mistakes that give at least half of the wrong answers, of the exercise's own and of questions that are commonly misread: first the
/// one that gives most of them, then the one that gives most of the rest.
pub fn search(evidence: &Evidence<'_>, readings: &[Misreading]) -> Option<Cover> {
    if evidence.wrong < ALONE {
        return None;
    }
    let mut ones = ones(evidence, readings);
    let mut left = vec![true; evidence.wrong];
    let mut chosen: Vec<One> = Vec::new();
    while chosen.len() < SEVERAL {
        let new = |one: &One| {
            one.gives
                .iter()
                .zip(&left)
                .filter(|(g, l)| **g && **l)
                .count()
        };
        let allowed = if chosen.is_empty() { HIDDEN } else { 1 };
        let fits = |one: &One| new(one) >= ALONE && allowed * one.score.contradicted <= new(one);
        let fitting = ones.iter().enumerate().filter(|(_, one)| fits(one));
        let best = fitting.min_by_key(|(_, one)| {
            let left_out = evidence.wrong - new(one);
            let loss = left_out + one.score.contradicted;
            let denied = chosen.iter().filter(|before| !one.is_beside(before));
            (loss, one.score.contradicted, one.rank, denied.count())
        });
        let Some((best, _)) = best else { break };
        let one = ones.swap_remove(best);
        for (left, gives) in left.iter_mut().zip(&one.gives) {
            *left &= !gives;
        }
        chosen.push(one);
    }
    let explained = left.iter().filter(|left| !**left).count();
    (2 * explained >= evidence.wrong && explained > 0).then_some(Cover {
        chosen,
        explained,
        wrong: evidence.wrong,
    })
}

/// The mistakes that give enough of the wrong answers to be chosen.
fn ones(evidence: &Evidence<'_>, readings: &[Misreading]) -> Vec<One> {
    let examiner = evidence.examiner;
    let share = ALONE as f64 / evidence.wrong as f64;
    let one = |name: &str, hint: &str, rank, answer: &dyn Fn(usize) -> Option<Vec<f64>>| {
        let answers: Vec<_> = (0..evidence.items.len()).map(answer).collect();
        let score = evidence.score(share, |k| answers[k].clone())?;
        let gives = |k: usize| {
            let answer = answers[k].as_ref();
            answer.is_some_and(|answer| evidence.explains(k, answer))
        };
        let shows = |k: usize| {
            let is_right = |answer: &Vec<f64>| evidence.is_right(&evidence.items[k], answer);
            !answers[k].as_ref().is_some_and(is_right)
        };
        Some(One {
            name: name.to_owned(),
            hint: hint.to_owned(),
            rank,
            score,
            gives: (0..evidence.wrong).map(gives).collect(),
            shows: (0..evidence.wrong).map(shows).collect(),
            shown: evidence.first_explained(&answers),
        })
    };
    let mistakes: Vec<_> = examiner.mistakes().into_iter().enumerate().collect();
    let own = found_of_each(&mistakes, |&(i, (name, hint))| {
        one(name, hint, 0, &|k| evidence.mistaken(i, k))
    });
    let common = readings.iter().filter(|reading| reading.rank <= COMMON);
    let common: Vec<_> = common.collect();
    let read = found_of_each(&common, |reading| {
        let answer = |k: usize| misread(evidence, reading, k);
        one(&reading.name, &reading.hint, reading.rank, &answer)
    });
    own.chain(read).collect()
}
