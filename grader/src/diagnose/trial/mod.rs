//! The trial of a mistake that the answers leave in doubt: further questions on which it shows, and which tell it from others.
//!
//! Two wrong answers of yes or no are those of many mistakes. Who suspects one of them asks where it shows: if each further answer is as it
//! says, and no other suspect that says anything else is left, it is the one. Where answers are compared by their traits, further random
//! cases are asked, and the traits of all tell.

mod among;
mod questions;
mod suspects;

use super::evidence::Evidence;
use super::misread::misreadings;
use super::search::search;
use super::{Beside, Diagnosis, spread};
use crate::examine::{Case, Examiner, visible_rng};
use among::{SURE, left};
use questions::questions;
use std::iter;
use suspects::{Suspect, suspects};

/// Questions on which a mistake shows that tell enough, and those by which it is told from each other suspect.
const ENOUGH: usize = 8;

/// Rounds of random cases that are asked where answers are compared by their traits.
const ROUNDS: usize = 3;

/// What is suspected, and what is asked to know.
pub struct Trial<'a> {
    evidence: Evidence<'a>,
    told: &'a Diagnosis,
    way: Way<'a>,
    /// The further questions.
    pub cases: Vec<Case>,
}

/// How the truth is found.
enum Way<'a> {
    /// By questions that tell these suspects apart, of whom the first is told.
    Suspects(Vec<Suspect<'a>>),
    /// By random cases in which the same is found again: what is told is made of right answers, and says nothing of questions that were not asked.
    Again,
    /// By the traits of all answers, those to random cases too: the more they are, the less they scatter.
    Traits,
}

impl<'a> Way<'a> {
    /// How to try what is told of these answers; none if nothing can be asked.
    fn of(evidence: &Evidence<'a>, told: &Diagnosis) -> Option<Self> {
        let is_judged = evidence.is_judged();
        let is_own = evidence.examiner.mistake_called(&told.name).is_some();
        let mut suspects = suspects(evidence, told);
        // Of two that are compared by their traits, none is convicted alone.
        let are_two = second(told).is_some() && !is_judged;
        if are_two && !suspects.iter().any(Suspect::is_two) {
            suspects.clear();
        }
        // A guess that is certain is told, unless one of the exercise's own says the same.
        if told.certain && suspects.iter().all(|suspect| suspect.is_guess) {
            return None;
        }
        let first = suspects.first();
        if first.is_some_and(|first| is_judged || first.name == told.name) {
            return Some(Self::Suspects(suspects));
        }
        if !is_judged {
            return is_own.then_some(Self::Traits);
        }
        // Of half of the answers there is more to find than the same again.
        let is_whole = told.explained == told.wrong && told.wrong >= ENOUGH;
        (is_whole && told.beside == Beside::Apart).then_some(Self::Again)
    }
}

impl<'a> Trial<'a> {
    /// A trial of what is told of these answers; none if nothing is in doubt, or nothing can be asked.
    pub fn new(
        examiner: &'a dyn Examiner,
        cases: &[Case],
        answers: &[(Option<String>, bool)],
        told: &'a Diagnosis,
    ) -> Option<Self> {
        let is_own = examiner.mistake_called(&told.name).is_some();
        if told.part.is_some() || told.certain && (is_own || told.beside == Beside::Shown) {
            return None;
        }
        let rng = &mut visible_rng(&format!("{}, once more", cases.last()?.question));
        let evidence = Evidence::new(examiner, cases, answers);
        let way = Way::of(&evidence, told)?;
        let mut random = |rounds| -> Option<Vec<Case>> {
            let rounds = (0..rounds).map(|_| examiner.try_random_cases(rng));
            let rounds = rounds.collect::<Result<Vec<_>, _>>().ok()?;
            Some(rounds.into_iter().flat_map(|one| one.cases).collect())
        };
        let cases = match &way {
            Way::Suspects(suspects) => questions(&evidence, suspects, rng),
            Way::Again => random(1)?,
            Way::Traits => random(ROUNDS)?,
        };
        Some(Self {
            evidence,
            told,
            way,
            cases,
        })
    }

    /// Whether more questions may tell what these did not: traits of more answers scatter less.
    pub fn is_open(&self) -> bool {
        matches!(self.way, Way::Traits)
    }

    /// What is told after it: for certain, if all is as one suspect says, and no right answer denied it before; else none. `cases` and
    /// `answers` are those of before, and behind them the further ones.
    pub fn verdict(&self, cases: &[Case], answers: &[(Option<String>, bool)]) -> Option<Diagnosis> {
        // Of all answers together it is known best how estimates scatter.
        let all = self.evidence.and_further(cases, answers);
        match &self.way {
            Way::Again => self.found_again(&all),
            Way::Traits => self.told_by_traits(&all),
            Way::Suspects(suspects) => {
                let before = cases.len() - self.cases.len();
                let examiner = self.evidence.examiner;
                let further = Evidence::new(examiner, &self.cases, &answers[before..]);
                self.told_apart(suspects, &further, &all)
            }
        }
    }

    /// What is told of the only suspect that is left.
    fn told_apart(
        &self,
        suspects: &[Suspect<'_>],
        further: &Evidence<'_>,
        all: &Evidence<'_>,
    ) -> Option<Diagnosis> {
        let left = left(suspects, further, all);
        let only = left.only(further)?;
        // What two explain together, one of them does not.
        let is_told = only.name == self.told.name && second(self.told).is_none();
        let before = if is_told { self.told.explained } else { 0 };
        let one = Diagnosis {
            name: only.name.clone(),
            hint: only.hint.clone(),
            explained: only.score.explained.max(before),
            further: further.wrong,
            beside: Beside::Apart,
            ..self.told.clone()
        };
        // What was told instead of it may be acquitted.
        let is_acquitted = |also: &&Diagnosis| {
            let is_suspect = further.examiner.mistake_called(&also.name).is_some();
            also.beside == Beside::Instead && is_suspect && !left.has(&also.name)
        };
        let also = only.also.as_ref().filter(|also| !is_acquitted(also));
        Some(self.convicted(&one, also))
    }

    /// What is told if the traits of all answers are those of the same as before, or of one of the same two, and of nothing else.
    fn told_by_traits(&self, all: &Evidence<'_>) -> Option<Diagnosis> {
        let found = spread::search(all, None).filter(|found| found.is_alone)?;
        let further = found.diagnosis.explained.checked_sub(self.told.explained)?;
        let told = names(self.told);
        let mut names = names(&found.diagnosis).into_iter();
        let one = Diagnosis {
            name: found.diagnosis.name.clone(),
            hint: found.diagnosis.hint.clone(),
            ..self.told.clone()
        };
        names.all(|name| told.contains(&name)).then(|| Diagnosis {
            further,
            ..self.convicted(&one, second(&found.diagnosis))
        })
    }

    /// What is told, for certain, if the same is found in all answers: to the last digits, and nothing else.
    fn found_again(&self, all: &Evidence<'_>) -> Option<Diagnosis> {
        let asked = all.examiner.asked();
        let found = search(all, &misreadings(asked.question, all.examiner.limits()))?;
        let again = found.told(all);
        let further = again.explained.checked_sub(self.told.explained)?;
        let is_sharp = found.is_sharp() || found.score.sharp >= SURE;
        let is_clear = found.is_exact() && is_sharp && !found.score.is_doubtful;
        let is_alone = found.rival.is_none() && !found.is_categorical();
        let is_same = names(&again) == names(self.told);
        (is_clear && is_alone && is_same && further >= ENOUGH).then(|| Diagnosis {
            further,
            ..self.convicted(self.told, second(self.told))
        })
    }

    /// What is told of a mistake for certain, and of another one with it, beside what there is to see of it, and what is told of other answers.
    /// Where two were told and one of them is certain, the other one is told of the answers that are left.
    fn convicted(&self, one: &Diagnosis, also: Option<&Diagnosis>) -> Diagnosis {
        let sure = |told: &Diagnosis| Diagnosis {
            certain: true,
            explained: one.explained,
            also: Vec::new(),
            ..told.clone()
        };
        let is_kept = |told: &&Diagnosis| match told.beside {
            Beside::Shown => true,
            Beside::Apart => {
                one.name == self.told.name && also.is_none_or(|also| also.name != told.name)
            }
            Beside::Together | Beside::Instead => false,
        };
        let kept = self.told.also.iter().filter(is_kept).cloned();
        let rest = self.told.explained.saturating_sub(one.explained);
        let is_alone = one.name == self.told.name && also.is_none() && rest > 0;
        let perhaps = second(self.told)
            .filter(|_| is_alone)
            .map(|told| Diagnosis {
                certain: false,
                explained: rest,
                beside: Beside::Apart,
                also: Vec::new(),
                ..told.clone()
            });
        Diagnosis {
            also: also.map(sure).or(perhaps).into_iter().chain(kept).collect(),
            ..sure(one)
        }
    }
}

/// The mistake that is told to be made together with it.
fn second(told: &Diagnosis) -> Option<&Diagnosis> {
    let mut also = told.also.iter();
    also.find(|also| also.beside == Beside::Together)
}

/// The names of the mistakes that are told to be made together, in the order of the alphabet.
fn names(told: &Diagnosis) -> Vec<&str> {
    let all = iter::once(told).chain(second(told));
    let mut names: Vec<_> = all.map(|one| one.name.as_str()).collect();
    names.sort_unstable();
    names
}

/// Whether two answers are the same but for the last digits, which hang on the order in which two mistakes are made.
fn same(one: Option<&[f64]>, other: Option<&[f64]>) -> bool {
    /// Numbers that differ by no more than this share of them are one number.
    const SAME: f64 = 1e-6;
    let (Some(one), Some(other)) = (one, other) else {
        return one.is_none() && other.is_none();
    };
    let mut pairs = one.iter().zip(other);
    let near = |(a, b): (&f64, &f64)| {
        a == b || a.is_nan() && b.is_nan() || (a - b).abs() <= SAME * a.abs().max(b.abs())
    };
    one.len() == other.len() && pairs.all(near)
}
