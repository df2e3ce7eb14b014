//! Which mistake a student made: the one that explains all answers best.
//!
//! An explanation says what a function with a certain mistake answers. Its answers are compared with the student's in all cases: it must
//! give the wrong answers, and must not contradict the right ones. Explanations are the exercise's own mistakes; the right answer to
//! a question that was misread; what a mistake makes of the right answer, with a number that fits; and two of these, one after the
//! other. An answer of several parts may have a mistake in each.

mod evidence;
mod fit;
mod flaws;
mod function;
pub mod misread;
mod number;
mod scalars;
mod special;
mod spread;

use crate::examine::{Case, Examiner};
use evidence::{Evidence, Scope, Score};
use fit::{Answers, Explanation};
use misread::{Misreading, misreadings};
use raybook_workbook::exercise::Asked;
use raybook_workbook::kind::Kind;
use std::panic::{AssertUnwindSafe, catch_unwind};

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
    /// Other mistakes: made after this one, or in other parts of the answer, or in other cases.
    pub also: Vec<Diagnosis>,
}

/// An explanation must give this share of the wrong answers.
const MOST: f64 = 0.8;

/// Wrong answers that an explanation is tried on before it is tried on all.
const PROBE: usize = 8;

/// Ways to misread a question that are tried in pairs, the likeliest first.
const PAIRS: usize = 60;

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
    if evidence.wrong == 0 {
        return None;
    }
    let mut diagnosis = of_all(&evidence).or_else(|| flaws::common(&evidence))?;
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
    // A mistake whose answers have the same traits says more than what can be seen in any answer, and that more than a guess.
    let likely = spread::search(evidence, &readings);
    let seen = flaws::search(evidence);
    let is_certain = |found: &&Diagnosis| found.certain;
    let certain = likely.iter().chain(&seen).find(is_certain);
    if let Some(found) = certain {
        return Some(found.clone());
    }
    if let Some(found) = complete {
        return Some(found.told(evidence));
    }
    if let Some(found) = seen.or(likely) {
        return Some(found);
    }
    let found = of_parts(evidence, &readings);
    let complete = |found: &&Vec<Diagnosis>| found.iter().all(|one| one.certain);
    let in_parts = |found: Vec<Diagnosis>| {
        let mut found = found.into_iter();
        let first = found.next()?;
        Some(Diagnosis {
            also: found.collect(),
            ..first
        })
    };
    match (whole, found) {
        (_, found) if !found.is_empty() && complete(&&found) => in_parts(found),
        (Some(whole), _) => Some(whole.told(evidence)),
        (None, found) if !found.is_empty() => in_parts(found),
        (None, _) => in_cases(evidence, &readings),
    }
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

/// What explains some of the wrong answers, and what explains others.
fn in_cases(evidence: &Evidence<'_>, readings: &[Misreading]) -> Option<Diagnosis> {
    let some = |evidence: &Evidence<'_>| {
        let share = (3.0 / evidence.wrong as f64).clamp(0.25, 1.0);
        let mut found = Vec::new();
        plain(evidence, readings, share, &mut found);
        let tells = |one: &Found| {
            one.score.tells >= 1.0 && 2 * one.score.contradicted <= one.score.explained
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
    let mut rest = evidence.clone();
    rest.items.clear();
    rest.wrong = 0;
    for (i, item) in evidence.items.iter().enumerate() {
        let explained = first.answers[i]
            .as_ref()
            .is_some_and(|answer| evidence.explains(i, answer));
        if item.right || !explained {
            rest.wrong += usize::from(!item.right);
            rest.items.push(item.clone());
        }
    }
    let mut told = first.told(evidence);
    told.certain = false;
    if rest.wrong > 0
        && let Some(second) = some(&rest)
    {
        let mut second = second.told(&rest);
        second.certain = false;
        told.also.push(second);
    }
    Some(told)
}

/// An explanation, and how well it agrees.
struct Found {
    name: String,
    hint: String,
    /// A mistake made after the first.
    then: Option<(String, String)>,
    rank: u32,
    fitted: u32,
    score: Score,
    answers: Answers,
}

impl Found {
    /// Small is good.
    fn key(&self) -> (usize, u32, usize) {
        let loss = self.score.missed + self.score.contradicted;
        (
            loss,
            self.rank + 2 * self.fitted,
            usize::MAX - self.score.close,
        )
    }

    /// Whether it explains all wrong answers, and contradicts no right one.
    fn is_complete(&self) -> bool {
        self.score.missed + self.score.contradicted == 0
    }

    fn is_own(&self) -> bool {
        self.rank == 0
    }

    /// Whether it may be told at all.
    fn holds(&self) -> bool {
        let Score {
            explained,
            missed,
            contradicted,
            tells,
            ..
        } = self.score;
        if tells >= 1.0 {
            contradicted <= explained || missed == 0 && self.fitted == 0
        } else {
            2 * contradicted <= explained
        }
    }

    fn is_certain(&self) -> bool {
        let Score {
            missed,
            contradicted,
            tells,
            explained,
            ..
        } = self.score;
        let categorical = tells < 0.9 * explained as f64;
        let needed = match (self.is_own(), categorical) {
            (true, _) => 1.0,
            (false, true) => f64::INFINITY,
            (false, false) => 2.0 + f64::from(self.fitted),
        };
        // Of two mistakes at once there are so many pairs that one may fit by chance.
        missed == 0 && contradicted == 0 && tells >= needed && self.then.is_none()
    }

    fn told(&self, evidence: &Evidence<'_>) -> Diagnosis {
        let part = match evidence.scope {
            Scope::Whole => None,
            Scope::Part(part) => Some(evidence.parts[part].name.clone()),
            Scope::Shape => Some("the number of answers".to_owned()),
        };
        let one = |name: &String, hint: &String| Diagnosis {
            name: name.clone(),
            hint: hint.clone(),
            part: part.clone(),
            certain: self.is_certain(),
            explained: self.score.explained,
            wrong: evidence.wrong,
            also: Vec::new(),
        };
        let then = self.then.iter().map(|(name, hint)| one(name, hint));
        Diagnosis {
            also: then.collect(),
            ..one(&self.name, &self.hint)
        }
    }
}

/// The explanation that agrees best with the evidence.
fn search(evidence: &Evidence<'_>, readings: &[Misreading]) -> Option<Found> {
    let mut found = Vec::new();
    plain(evidence, readings, MOST, &mut found);
    if !found.iter().any(Found::is_complete) && evidence.scope != Scope::Shape {
        pairs(evidence, readings, &mut found);
    }
    found.retain(Found::holds);
    best(found)
}

/// The best: of the exercise's own mistakes that agree as well as each other, the one that is nearest to all answers.
fn best(found: Vec<Found>) -> Option<Found> {
    found.into_iter().min_by_key(Found::key)
}

/// All explanations by one mistake that give this share of the wrong answers.
fn plain(evidence: &Evidence<'_>, readings: &[Misreading], share: f64, found: &mut Vec<Found>) {
    let examiner = evidence.examiner;
    for (i, (name, hint)) in examiner.mistakes().into_iter().enumerate() {
        let answer = |k: usize| examiner.mistake_answers(i, &evidence.items[k].question);
        let (name, hint) = (name.to_owned(), hint.to_owned());
        let one = Explanation {
            name,
            hint,
            rank: 0,
            fitted: 0,
            answers: Vec::new(),
        };
        consider(evidence, share, one, &answer, found);
    }
    if share >= MOST && found.iter().any(Found::is_complete) {
        return; // a mistake of its own is told before any other
    }
    let golden = golden(evidence);
    let mut made = special::explanations(evidence, &golden);
    made.extend(fit::explanations(evidence, &golden, true));
    for one in made {
        let answers = one.answers.clone();
        consider(evidence, share, one, &|k| answers[k].clone(), found);
    }
    for reading in readings {
        let answer = |k: usize| misread(evidence, reading, k);
        let (name, hint) = (reading.name.clone(), reading.hint.clone());
        let one = Explanation {
            name,
            hint,
            rank: reading.rank,
            fitted: 0,
            answers: Vec::new(),
        };
        consider(evidence, share, one, &answer, found);
    }
}

fn golden(evidence: &Evidence<'_>) -> Answers {
    evidence
        .items
        .iter()
        .map(|item| Some(item.golden().to_vec()))
        .collect()
}

/// The right answer to an item's question, misread.
fn misread(evidence: &Evidence<'_>, reading: &Misreading, item: usize) -> Option<Vec<f64>> {
    let (asked, item) = (evidence.examiner.asked(), &evidence.items[item]);
    match reading.read(asked.question, &item.question) {
        Some(question) => called(asked, &question),
        None => Some(item.golden().to_vec()),
    }
}

/// The right answer to a question that may make no sense; none if the library panics.
fn called(asked: &Asked, question: &[f64]) -> Option<Vec<f64>> {
    catch_unwind(|| (asked.call)(question)).ok()
}

fn consider(
    evidence: &Evidence<'_>,
    share: f64,
    one: Explanation,
    answer: &dyn Fn(usize) -> Option<Vec<f64>>,
    found: &mut Vec<Found>,
) {
    let Some(score) = evidence.score(share, answer) else {
        return;
    };
    let answers = if one.answers.is_empty() {
        (0..evidence.items.len()).map(answer).collect()
    } else {
        one.answers
    };
    let Explanation {
        name,
        hint,
        rank,
        fitted,
        ..
    } = one;
    found.push(Found {
        name,
        hint,
        then: None,
        rank,
        fitted,
        score,
        answers,
    });
}

/// Explanations by two mistakes, one after the other: what is made of the answer of another mistake, or of a question misread.
#[allow(clippy::too_many_lines, clippy::type_complexity)] // two searches over the same first mistakes
fn pairs(evidence: &Evidence<'_>, readings: &[Misreading], found: &mut Vec<Found>) {
    let examiner = evidence.examiner;
    let asked = examiner.asked();
    let probe = evidence.probe(PROBE);
    if examiner.limits().slow || probe.wrong < 3 || !probe.tells_much() {
        return;
    }
    let mistakes = examiner.mistakes();
    let of_mistake = |i: usize, question: &[f64]| {
        catch_unwind(AssertUnwindSafe(|| examiner.mistake_answers(i, question))).ok()?
    };
    let of_reading = |reading: &Misreading, question: &[f64]| {
        called(asked, &reading.read(asked.question, question)?)
    };
    let mut firsts: Vec<(
        String,
        String,
        u32,
        Box<dyn Fn(&[f64]) -> Option<Vec<f64>> + '_>,
    )> = Vec::new();
    for (i, (name, hint)) in mistakes.iter().enumerate() {
        let answer = move |question: &[f64]| of_mistake(i, question);
        firsts.push(((*name).to_owned(), (*hint).to_owned(), 0, Box::new(answer)));
    }
    for reading in readings.iter().filter(|reading| reading.rank < 17) {
        let answer = move |question: &[f64]| of_reading(reading, question);
        firsts.push((
            reading.name.clone(),
            reading.hint.clone(),
            reading.rank,
            Box::new(answer),
        ));
    }
    for (name, hint, rank, answer) in &firsts {
        let few: Answers = probe
            .items
            .iter()
            .map(|item| answer(&item.question))
            .collect();
        let changed = few
            .iter()
            .zip(&probe.items)
            .filter(|(few, item)| few.as_deref() != Some(item.golden()))
            .count();
        if 2 * changed < probe.wrong {
            continue;
        }
        for second in fit::explanations(&probe, &few, false) {
            if probe.score(0.99, |k| second.answers[k].clone()).is_none() {
                continue;
            }
            let all: Answers = evidence
                .items
                .iter()
                .map(|item| answer(&item.question))
                .collect();
            // The number that fits is that of all wrong answers.
            let again = fit::explanations(evidence, &all, false);
            for again in again.into_iter().filter(|again| again.name == second.name) {
                let answers = again.answers;
                let Some(score) = evidence.score(MOST, |k| answers[k].clone()) else {
                    continue;
                };
                found.push(Found {
                    name: name.clone(),
                    hint: hint.clone(),
                    then: Some((again.name, again.hint)),
                    rank: 40 + rank + again.rank,
                    fitted: again.fitted,
                    score,
                    answers,
                });
            }
        }
    }
    let mut twice = |name: (&str, &str),
                     then: (&str, &str),
                     rank,
                     answer: &dyn Fn(&[f64]) -> Option<Vec<f64>>| {
        if probe
            .score(0.99, |k| answer(&probe.items[k].question))
            .is_none()
        {
            return;
        }
        let answers: Answers = evidence
            .items
            .iter()
            .map(|item| answer(&item.question))
            .collect();
        if let Some(score) = evidence.score(MOST, |k| answers[k].clone()) {
            found.push(Found {
                name: name.0.to_owned(),
                hint: name.1.to_owned(),
                then: Some((then.0.to_owned(), then.1.to_owned())),
                rank,
                fitted: 0,
                score,
                answers,
            });
        }
    };
    let mut common: Vec<_> = readings.iter().collect();
    common.sort_by_key(|reading| reading.rank);
    for (k, reading) in common.iter().enumerate() {
        for (i, (name, hint)) in mistakes.iter().enumerate() {
            let answer = |question: &[f64]| of_mistake(i, &reading.read(asked.question, question)?);
            twice(
                (name, hint),
                (&reading.name, &reading.hint),
                45 + reading.rank,
                &answer,
            );
        }
        for other in common[..k.min(PAIRS)].iter().filter(|_| k < PAIRS) {
            let answer =
                |question: &[f64]| of_reading(reading, &other.read(asked.question, question)?);
            twice(
                (&other.name, &other.hint),
                (&reading.name, &reading.hint),
                60 + reading.rank + other.rank,
                &answer,
            );
        }
    }
}
