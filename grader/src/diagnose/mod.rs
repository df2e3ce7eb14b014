//! Which mistake a student made: the one that explains all answers best.
//!
//! An explanation says what a function with a certain mistake answers. Its answers are compared with the student's in all cases: it must
//! give the wrong answers, and must not contradict the right ones. Explanations are the exercise's own mistakes; the right answer to
//! a question that was misread; what a mistake makes of the right answer, with a number that fits; and two of these, one after the
//! other, or each in other cases. An answer of several parts may have a mistake in each.

mod beyond;
mod branch;
mod component;
mod cover;
pub(crate) mod evidence;
mod fit;
pub(crate) mod flaws;
mod found;
pub(crate) mod function;
pub mod misread;
mod number;
mod pairs;
mod panics;
mod regime;
mod rest;
mod scalars;
pub(crate) mod search;
pub(crate) mod slips;
mod special;
mod spread;
pub mod ties;
pub mod trial;

use crate::examine::{Case, Examiner};
use evidence::{Evidence, Scope};
use found::Found;
use misread::{Misreading, misreadings};
pub use panics::with_panics;
use raybook_workbook::kind::Kind;
use search::{plain, search, slip_of_structure};

/// A mistake that explains wrong answers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnosis {
    /// What the mistake does.
    pub name: String,
    /// A sentence that leads on.
    pub hint: String,
    /// The part of the answer in which it shows, if not in all of it.
    pub part: Option<String>,
    /// Whether it explains all wrong answers and contradicts no right one, and no other mistake does so as well.
    pub certain: bool,
    /// How many of the wrong answers are the mistake's.
    pub explained: usize,
    /// How many answers are wrong.
    pub wrong: usize,
    /// How many further wrong answers are the mistake's, which were asked for because it was in doubt.
    pub further: usize,
    /// The first case that it explains, by its place among all cases, where that is known.
    pub shown: Option<usize>,
    /// How it goes with the mistake that is told before it, if there is one.
    pub beside: Beside,
    /// Other mistakes.
    pub also: Vec<Diagnosis>,
}

impl Diagnosis {
    /// Whether a mistake of this name is told.
    fn tells(&self, name: &str) -> bool {
        self.name == name || self.also.iter().any(|also| also.name == name)
    }
}

/// How another mistake goes with the one that is told first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beside {
    /// In other parts of the answer, or in other cases.
    Apart,
    /// In the same answers, which only both together explain.
    Together,
    /// It alone explains the same answers as well.
    Instead,
    /// It is no other mistake, but what there is to see of the first.
    Shown,
}

/// An explanation must give this share of the wrong answers.
const MOST: f64 = 0.8;

/// What may have made what is seen in the answers must explain answers that tell this much.
const TELLS: f64 = 2.0;

/// The rank of the last mistake that is common enough to be told of yes and no before two others that explain them together.
const COMMON: u32 = 24;

/// What is seen in single parts only must give this share of them.
const SOME: f64 = 0.4;

/// The mistake whose answers these are.
///
/// `answers` holds, for each case, what the student answered (`None` for no answer) and whether it was right.
pub fn diagnose(
    examiner: &dyn Examiner,
    cases: &[Case],
    answers: &[(Option<String>, bool)],
) -> Option<Diagnosis> {
    let wrong = answers.iter().filter(|(_, right)| !right).count();
    let evidence = Evidence::new(examiner, cases, answers);
    let read = Some(&evidence).filter(|evidence| evidence.wrong > 0);
    // What is seen in a few answers tells nothing of those that did not come.
    let came = 2 * evidence.wrong >= wrong;
    let found = read.and_then(of_all).map(|found| Diagnosis {
        certain: found.certain && came,
        ..found
    });
    let named = |one: &Diagnosis| {
        let mut own = examiner.mistakes().into_iter();
        one.certain || own.any(|(name, _)| name == one.name)
    };
    let mut diagnosis = match found {
        Some(found) if named(&found) => found,
        found => {
            // What is seen in a branch says more than a guess, which may be its cause, and that more than a branch.
            match branch::search(examiner, cases, answers) {
                Some(seen) if seen.certain => {
                    let cause = |one: &Diagnosis| one.explained == wrong && one.also.is_empty();
                    Diagnosis {
                        also: found.filter(cause).into_iter().collect(),
                        ..seen
                    }
                }
                branch => found.or(branch).or_else(|| regime::search(&evidence))?,
            }
        }
    };
    if flaws::are_called(&diagnosis.name, examiner) {
        regime::add_to(&mut diagnosis, &evidence);
    }
    let seeds = flaws::of_seeds(&evidence, &diagnosis);
    diagnosis.also.extend(seeds);
    diagnosis.wrong = wrong;
    for also in &mut diagnosis.also {
        also.wrong = wrong;
    }
    Some(diagnosis)
}

fn of_all(evidence: &Evidence<'_>) -> Option<Diagnosis> {
    let readings = misreadings(
        evidence.examiner.asked().question,
        evidence.examiner.limits(),
    );
    let whole = search(evidence, &readings);
    let complete = whole.as_ref().filter(|found| found.is_complete());
    if let Some(found) = complete.filter(|found| found.is_own() || found.is_certain()) {
        return Some(found.told(evidence));
    }
    let cover = cover::search(evidence, &readings);
    // Of several mistakes each explains a share; one that explains all is simpler, if the answers tell enough to know it. Of yes and no
    // many do: a common mistake seldom gives all the wrong ones and no right one by chance.
    let is_one = complete.is_some_and(|one| {
        let tells = 2.0 * one.score.tells >= one.score.explained as f64;
        one.then.is_none() && (tells || one.score.tells >= TELLS && one.rank <= COMMON)
    });
    // A question may be misread in many ways: one of them gives the rest of the answers by chance more often than an own mistake.
    let is_told = |cover: &&cover::Cover| {
        let is_told_better = || complete.is_some_and(Found::is_of_own);
        let is_own = cover.is_own() && (cover.go_together() || !is_told_better());
        cover.is_whole() && !is_one && (is_own || complete.is_none())
    };
    if let Some(found) = cover.as_ref().filter(is_told) {
        return found.told();
    }
    let first = whole
        .as_ref()
        .filter(|one| one.then.is_none() && complete.is_none());
    if let Some(found) = first.and_then(|first| rest::explained(evidence, &readings, first)) {
        return Some(found.told(evidence));
    }
    // A mistake whose answers have the same traits says more than what can be seen in any answer, and that more than a guess.
    let likely = spread::search(evidence, Some(&readings));
    let seen = flaws::search(evidence);
    let slip = slip_of_structure(evidence);
    // Two of the exercise's own that give all answers to the last digits say more than one whose traits are near.
    let two = complete.filter(|two| two.then.is_some() && two.is_of_own() && two.is_partly());
    if let Some(found) = likely.as_ref().filter(|one| one.diagnosis.certain) {
        let is_half = |two: &&Found| two.told(evidence).tells(&found.diagnosis.name);
        return match two.filter(is_half) {
            Some(two) => Some(two.told(evidence)),
            None => Some(found.diagnosis.clone()),
        };
    }
    if let Some(found) = seen.as_ref().filter(|found| found.certain) {
        return with_cause(
            evidence,
            &readings,
            found.clone(),
            whole.as_ref(),
            slip,
            likely,
        );
    }
    let (near, likely) = match likely {
        Some(one) if one.is_near() && one.is_cause => (Some(one.diagnosis), None),
        likely => (None, likely.map(|one| one.diagnosis)),
    };
    let most = whole.as_ref().map_or(0, |found| found.score.explained);
    // One mistake is told before two of which each is in a part of its own, and these before two one after the other.
    if let Some(found) = complete.filter(|found| found.then.is_none()) {
        return Some(found.told(evidence));
    }
    let parts = of_parts(evidence, &readings);
    let are_certain = parts.iter().all(|one| one.certain);
    if let Some(found) = complete.filter(|_| parts.is_empty() || !are_certain) {
        return Some(found.told(evidence));
    }
    let told: usize = parts.iter().map(|one| one.explained).sum();
    let tells = told as f64 >= SOME * evidence.wrong as f64;
    // What explains the parts that it is told of says more than what is seen in a few answers.
    let are_complete = parts.iter().all(|one| one.explained == one.wrong);
    let parts = in_parts(parts).filter(|_| tells);
    let complete_parts = parts.clone().filter(|_| are_complete);
    parts
        .clone()
        .filter(|_| are_certain)
        .or_else(|| cover.filter(|cover| cover.explained > most)?.told())
        .or_else(|| slip.clone().filter(|slip| slip.explained > most))
        .or_else(|| whole.map(|found| with_rest(evidence, &readings, &found)))
        .or(slip)
        .or(near)
        .or(complete_parts)
        .or(seen)
        .or(likely)
        .or(parts)
        .or_else(|| where_it_is(evidence, &readings))
        .or_else(|| partly(evidence, &readings))
        .or_else(|| in_cases(evidence, &readings))
        .or_else(|| flaws::of_some(evidence))
}

/// What may have made what is there to see in the answers.
fn because(mut cause: Diagnosis, seen: Diagnosis) -> Diagnosis {
    let with = |one: Diagnosis| Diagnosis {
        beside: Beside::Shown,
        ..one
    };
    if seen.name != cause.name {
        cause.also.push(with(seen));
    }
    cause
}

/// What is there to see in the answers, and what may have made it.
fn with_cause(
    evidence: &Evidence<'_>,
    readings: &[Misreading],
    found: Diagnosis,
    whole: Option<&Found>,
    slip: Option<Diagnosis>,
    likely: Option<spread::Likely>,
) -> Option<Diagnosis> {
    let complete = whole.filter(|found| found.is_complete());
    if slip.is_none() && evidence.examiner.limits().effort <= 1 {
        let parts = of_parts(evidence, readings);
        if !parts.is_empty() && parts.iter().all(|one| one.certain) {
            return in_parts(parts);
        }
    }
    let complete = complete.filter(|one| one.is_of_own() || one.then.is_none());
    let complete = complete.filter(|one| one.score.tells >= TELLS);
    let nearly = search::nearly(evidence);
    if let Some(cause) = complete.or(nearly.as_ref()) {
        return Some(because(cause.told(evidence), found));
    }
    let nearly =
        whole.filter(|one| one.is_own() && one.score.contradicted == 0 || one.is_nearly_complete());
    // One mistake whose answers have the same traits says more than two that explain nearly all.
    let is_simpler = likely
        .as_ref()
        .is_some_and(|one| one.is_exact() && one.is_cause);
    let nearly = nearly.filter(|one| one.then.is_none() || !is_simpler);
    // A slip that explains all comes before what explains nearly all.
    let explains_all = |one: &Diagnosis| one.explained == evidence.wrong;
    let is_less = slip.as_ref().is_some_and(explains_all);
    let nearly = nearly.filter(|one| one.is_own() || !is_less);
    let nearly = nearly.map(|one| one.told(evidence));
    let is_good =
        nearly.is_some() || slip.is_some() || likely.as_ref().is_some_and(spread::Likely::is_near);
    let likely = likely.filter(|one| one.is_cause).map(|one| one.diagnosis);
    let mut made = nearly.into_iter().chain(slip).chain(likely);
    let cause = made.find(|one| one.name != found.name);
    // Who knows what to look for is helped more than who knows what is wrong.
    match cause {
        Some(cause) if is_good => Some(because(cause, found)),
        None if evidence.is_judged() => match where_it_is(evidence, readings) {
            Some(cause) => Some(because(cause, found)),
            None => Some(found),
        },
        _ => Some(found),
    }
}

/// What explains most of the wrong answers, and what explains the rest of them.
fn with_rest(evidence: &Evidence<'_>, readings: &[Misreading], found: &Found) -> Diagnosis {
    let mut told = found.told(evidence);
    let rest = evidence.without(&found.answers);
    let second = rest.and_then(|rest| {
        let second = search(&rest, readings).filter(Found::is_complete)?;
        let second = second.told(&rest);
        (second.name != told.name).then_some(second)
    });
    let second = second.map(|second| Diagnosis {
        certain: false,
        ..second
    });
    // An own mistake leaves a rest that another one makes; a guess leaves what it does not fit.
    let where_it_is = || regime::of_rest(evidence, &found.answers).filter(|_| found.is_own());
    told.also.extend(second.or_else(where_it_is));
    told
}

/// A mistake in each of several parts.
fn in_parts(found: Vec<Diagnosis>) -> Option<Diagnosis> {
    let mut found = found.into_iter();
    let first = found.next()?;
    Some(Diagnosis {
        also: found.collect(),
        ..first
    })
}

/// What explains each part of the answer, most first.
fn of_parts(evidence: &Evidence<'_>, readings: &[Misreading]) -> Vec<Diagnosis> {
    let kind = evidence.examiner.asked().answer.kind;
    let mut scopes: Vec<_> = (0..evidence.parts.len()).map(Scope::Part).collect();
    if matches!(kind, Kind::Optional(_) | Kind::List(_)) {
        scopes.push(Scope::Shape);
    } else if scopes.len() < 2 {
        return Vec::new();
    }
    let mut found: Vec<Diagnosis> = Vec::new();
    for scope in scopes {
        let Some(of) = evidence.of(scope) else {
            continue;
        };
        let Some(one) = search(&of, readings) else {
            continue;
        };
        let mut one = one.told(&of);
        match found.iter_mut().find(|other| other.name == one.name) {
            // One mistake that shows in several parts is one mistake.
            Some(other) => {
                let parts = [other.part.take(), one.part.take()];
                let parts: Vec<_> = parts.into_iter().flatten().collect();
                other.part = Some(parts.join(" and "));
                other.certain &= one.certain;
                other.explained = other.explained.max(one.explained);
            }
            None => found.push(one),
        }
    }
    // What leaves most answers unexplained is no more than a guess.
    let explained: usize = found.iter().map(|one| one.explained).sum();
    for one in &mut found {
        one.certain &= explained as f64 >= MOST * evidence.wrong as f64;
    }
    found.sort_by_key(|one| (!one.certain, std::cmp::Reverse(one.explained)));
    found
}

/// What explains all wrong answers, and is made where the questions have something in common: there no right answer contradicts it.
fn where_it_is(evidence: &Evidence<'_>, readings: &[Misreading]) -> Option<Diagnosis> {
    let (found, words) = search::limited(evidence, readings)?;
    Some(Diagnosis {
        certain: false,
        ..found.told_only(evidence, Some(&format!("where {words}")))
    })
}

/// What explains all wrong answers, and is made in these cases only.
fn partly(evidence: &Evidence<'_>, readings: &[Misreading]) -> Option<Diagnosis> {
    let found = search::partly(evidence, readings)?;
    let only = regime::shared(evidence).map_or_else(
        || "in some cases".to_owned(),
        |words| format!("where {words}"),
    );
    Some(Diagnosis {
        certain: false,
        ..found.told_only(evidence, Some(&only))
    })
}

/// What explains some of the wrong answers, and what explains others.
fn in_cases(evidence: &Evidence<'_>, readings: &[Misreading]) -> Option<Diagnosis> {
    let some = |evidence: &Evidence<'_>| {
        let share = (3.0 / evidence.wrong as f64).clamp(0.25, 1.0);
        let mut found = Vec::new();
        plain(evidence, readings, share, &mut found);
        let tells = |one: &Found| {
            let often = one.is_own() || 2 * one.score.explained >= evidence.wrong;
            let speaks =
                one.score.tells >= 1.0 && 2 * one.score.contradicted <= one.score.explained;
            often && speaks && one.holds()
        };
        let found = found.into_iter().filter(tells);
        found.max_by_key(|one| {
            (
                one.score.explained,
                std::cmp::Reverse((one.score.contradicted, one.rank)),
            )
        })
    };
    let first = some(evidence)?;
    let mut told = first.told(evidence);
    told.certain = false;
    if let Some(rest) = evidence.without(&first.answers)
        && let Some(second) = some(&rest)
    {
        let mut second = second.told(&rest);
        second.certain = false;
        told.also.push(second);
    }
    Some(told)
}
