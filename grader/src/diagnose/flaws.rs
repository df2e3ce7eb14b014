//! What can be read off wrong answers themselves, where no mistake gives the same ones: complaints of the judge that have a name.

use super::evidence::{Evidence, Item};
use super::{Diagnosis, MOST};
use crate::Flaw;
use std::cmp::Reverse;

/// The flaw that most wrong answers have, or the two. It is certain if all of them have it, for it is there to see.
pub fn search(evidence: &Evidence<'_>) -> Option<Diagnosis> {
    let examiner = evidence.examiner;
    let wrong = &evidence.items[..evidence.wrong];
    let compared = wrong
        .iter()
        .map(|item| examiner.compare(&item.question, item.golden(), &item.got));
    let mut complaints: Vec<_> = compared.filter_map(Result::err).collect();
    if complaints.is_empty() {
        // Each of them is right, and all of them together are not.
        let row = |item: &Item| (item.question.clone(), item.got.clone());
        let together = examiner.compare_together(&wrong.iter().map(row).collect::<Vec<_>>());
        complaints = vec![together.err()?; evidence.wrong];
    }
    let count = |flaw: &Flaw| {
        let has = |why: &&String| why.contains(flaw.complaint);
        complaints.iter().filter(has).count()
    };
    let mut found: Vec<_> = examiner
        .flaws()
        .iter()
        .map(|flaw| told(flaw, count(flaw), evidence.wrong))
        .collect();
    found.retain(|one| one.explained > 0);
    found.sort_by_key(|one| Reverse(one.explained));
    let mut found = found.into_iter();
    let mut first = found.next()?;
    if first.explained < evidence.wrong {
        first.also.extend(found.next());
    }
    let explained = first.explained + first.also.iter().map(|one| one.explained).sum::<usize>();
    (explained as f64 >= MOST * evidence.wrong as f64).then_some(first)
}

fn told(flaw: &Flaw, explained: usize, wrong: usize) -> Diagnosis {
    Diagnosis {
        name: flaw.name.to_owned(),
        hint: flaw.hint.to_owned(),
        part: None,
        certain: explained == wrong,
        explained,
        wrong,
        also: Vec::new(),
    }
}
