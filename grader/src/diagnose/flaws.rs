//! What can be read off wrong answers themselves, where no mistake gives the same ones: complaints of the judge that have a name.

use super::evidence::{Evidence, Item};
use super::{Beside, Diagnosis, MOST};
use crate::Flaw;
use crate::examine::Examiner;
use crate::together::{Bounds, SEEDS};
use std::cmp::Reverse;
use std::collections::HashSet;
use std::iter;

/// The share of the wrong answers that a flaw must be seen in, if nothing better is known.
const SOME: f64 = 0.25;

/// Complaints that many judges have. They say less than an exercise's own.
const COMMON: &[Flaw] = &[
    Flaw {
        complaint: "is NaN",
        name: "returns NaN, which is not a number",
        hint: "Look for 0/0, ∞ − ∞ or the root of a negative number. Print the ingredients.",
    },
    Flaw {
        complaint: "a direction has length 1",
        name: "returns a direction whose length is not 1",
        hint: "How long must a direction be? How long are the vectors that yours is made of?",
    },
    Flaw {
        complaint: "but you returned none",
        name: "returns none where there is an answer",
        hint: "Which of your conditions turns these cases away? Print its ingredients for the first of them.",
    },
    Flaw {
        complaint: "but you returned one",
        name: "returns an answer where there is none",
        hint: "Which condition should turn these cases away? Print its ingredients for the first of them.",
    },
];

/// What the wrong answers of an exercise have in common by its own complaints.
pub fn search(evidence: &Evidence<'_>) -> Option<Diagnosis> {
    of(evidence.examiner.flaws(), evidence, MOST)
}

/// Whether this is the name of what can be seen in wrong answers, and not of a mistake.
pub fn are_called(name: &str, examiner: &dyn Examiner) -> bool {
    let mut all = examiner.flaws().iter().chain(COMMON);
    all.any(|flaw| flaw.name == name)
}

/// What some of them have in common, or what most have by complaints that many judges have.
pub fn of_some(evidence: &Evidence<'_>) -> Option<Diagnosis> {
    let some = of(evidence.examiner.flaws(), evidence, SOME);
    some.or_else(|| of(COMMON, evidence, MOST))
}

/// The flaw that most wrong answers have, or the two. It is certain if nearly all of them have it, for it is there to see.
fn of(flaws: &[Flaw], evidence: &Evidence<'_>, share: f64) -> Option<Diagnosis> {
    let examiner = evidence.examiner;
    let wrong = &evidence.items[..evidence.wrong];
    let complaint = |item: &Item| {
        let (question, golden) = (&item.question, item.golden());
        let compared = examiner.compare(question, golden, &item.got);
        let is_nan = item.got.iter().any(|v| v.is_nan());
        // A judge may stop at something else: that there is an answer at all.
        let why = examiner.complaint(question, golden, &item.got, compared.err()?);
        let why = if is_nan {
            format!("{why}, and is NaN")
        } else {
            why
        };
        Some((item.case, why))
    };
    let mut complaints: Vec<_> = wrong.iter().filter_map(complaint).collect();
    let by_itself: HashSet<_> = complaints.iter().map(|(case, _)| *case).collect();
    let together = wrong.iter().filter(|item| !by_itself.contains(&item.case));
    let together: Vec<_> = together.collect();
    // Each of them is right, and all of them together are not: as they came, for in another order neighbours are others.
    let row = |item: &&Item| (item.question.clone(), item.raw.clone());
    let rows: Vec<_> = together.iter().map(row).collect();
    if let Err(why) = examiner.compare_together(&rows, Bounds::CHANCE) {
        complaints.extend(together.iter().map(|item| (item.case, why.clone())));
    }
    let mut found: Vec<_> = flaws
        .iter()
        .map(|flaw| told(examiner, flaw, &complaints, evidence.wrong))
        .collect();
    found.retain(|one| one.explained > 0);
    found.sort_by_key(|one| Reverse(one.explained));
    let mut found = found.into_iter();
    let mut first = found.next()?;
    if first.explained < evidence.wrong {
        first.also.extend(found.next());
    }
    let also: usize = first.also.iter().map(|one| one.explained).sum();
    // A few answers may have another flaw that hides this one.
    first.certain = first.explained + also == evidence.wrong && also <= first.explained / 8;
    // What has the name of a mistake says what the function does everywhere, which more right answers than wrong ones deny.
    let is_mistake = first.beside == Beside::Apart;
    first.certain &= !is_mistake || 2 * evidence.wrong >= evidence.items.len();
    ((first.explained + also) as f64 >= share * evidence.wrong as f64).then_some(first)
}

/// The flaw that a complaint of all answers together is about, of which these are as many.
pub fn of_all_together(examiner: &dyn Examiner, why: &str, answers: usize) -> Option<Diagnosis> {
    let complaints: Vec<_> = (0..answers).map(|case| (case, why.to_owned())).collect();
    let mut flaws = examiner.flaws().iter();
    let flaw = flaws.find(|flaw| why.contains(flaw.complaint))?;
    Some(told(examiner, flaw, &complaints, answers))
}

/// What is wrong with the seed, beside what is told already: equal points of two seeds are there to see, whatever the points are. Who
/// makes them without random numbers ignores no seed.
pub fn of_seeds(evidence: &Evidence<'_>, told: &Diagnosis) -> Option<Diagnosis> {
    let examiner = evidence.examiner;
    let complaint = |answer: &dyn Fn(&Item) -> Option<Vec<f64>>| {
        let row = |item: &Item| Some((item.question.clone(), answer(item)?));
        let rows: Vec<_> = evidence.items.iter().filter_map(row).collect();
        let why = examiner.compare_together(&rows, Bounds::CHANCE).err();
        why.filter(|why| why.starts_with(SEEDS))
    };
    let why = complaint(&|item| Some(item.raw.clone()))?;
    let mut all = iter::once(told).chain(&told.also);
    let is_caused = all.any(|one| {
        let own = examiner.mistake_called(&one.name);
        own.is_some_and(|i| {
            complaint(&|item| examiner.mistake_answers(i, &item.question)).is_some()
        })
    });
    if is_caused {
        return None;
    }
    of_all_together(examiner, &why, evidence.wrong).filter(|seeds| !told.tells(&seeds.name))
}

/// A flaw, and how many of the complaints, each of a case, are about it. It is there to see, and explains nothing, unless it is called as a
/// mistake is.
fn told(
    examiner: &dyn Examiner,
    flaw: &Flaw,
    complaints: &[(usize, String)],
    wrong: usize,
) -> Diagnosis {
    let is_mistake = examiner.mistake_called(flaw.name).is_some();
    let of_it = complaints
        .iter()
        .filter(|(_, why)| why.contains(flaw.complaint));
    let cases: Vec<_> = of_it.map(|(case, _)| *case).collect();
    let explained = cases.len();
    Diagnosis {
        name: flaw.name.to_owned(),
        hint: flaw.hint.to_owned(),
        part: None,
        certain: explained == wrong,
        explained,
        wrong,
        further: 0,
        shown: cases.into_iter().min(),
        beside: if is_mistake {
            Beside::Apart
        } else {
            Beside::Shown
        },
        also: Vec::new(),
    }
}
