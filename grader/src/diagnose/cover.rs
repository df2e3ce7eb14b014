//! Several of the exercise's own mistakes in one function, each of which shows in other cases: who begins makes two at once.

use super::evidence::{Evidence, Score};
use super::{Beside, Diagnosis};
use crate::attempt::attempt;

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
    name: &'static str,
    hint: &'static str,
    score: Score,
    /// Of each wrong answer, whether the mistake gives it.
    gives: Vec<bool>,
    /// The first case that it gives.
    shown: Option<usize>,
}

impl Cover {
    /// Whether they are several, and give all wrong answers.
    pub fn is_whole(&self) -> bool {
        self.chosen.len() > 1 && self.explained == self.wrong
    }

    /// Certain, if they give all wrong answers, nothing contradicts them, and the answers say more than yes or no.
    pub fn told(&self) -> Option<Diagnosis> {
        let clear = |one: &One| {
            one.score.contradicted == 0 && one.score.tells >= 1.0 && !one.score.is_doubtful
        };
        let certain = self.is_whole() && self.chosen.iter().all(clear);
        let told = |one: &One| Diagnosis {
            name: one.name.to_owned(),
            hint: one.hint.to_owned(),
            part: None,
            certain,
            explained: one.score.explained,
            wrong: self.wrong,
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

/// The exercise's own mistakes that give at least half of the wrong answers: first the one that gives most of them, then the one that gives
/// most of the rest.
pub fn search(evidence: &Evidence<'_>) -> Option<Cover> {
    if evidence.wrong < ALONE {
        return None;
    }
    let mut ones = ones(evidence);
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
            (left_out + one.score.contradicted, one.score.contradicted)
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
fn ones(evidence: &Evidence<'_>) -> Vec<One> {
    let examiner = evidence.examiner;
    let share = ALONE as f64 / evidence.wrong as f64;
    let one = |(i, (name, hint)): (usize, (&'static str, &'static str))| {
        let answer = |question: &[f64]| attempt(|| examiner.mistake_answers(i, question))?;
        let answers = evidence.items.iter().map(|item| answer(&item.question));
        let answers: Vec<_> = answers.collect();
        let score = evidence.score(share, |k| answers[k].clone())?;
        let gives = |k: usize| {
            let answer = answers[k].as_ref();
            answer.is_some_and(|answer| evidence.explains(k, answer))
        };
        Some(One {
            name,
            hint,
            score,
            gives: (0..evidence.wrong).map(gives).collect(),
            shown: evidence.first_explained(&answers),
        })
    };
    let mistakes = examiner.mistakes().into_iter().enumerate();
    mistakes.filter_map(one).collect()
}
