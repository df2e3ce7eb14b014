//! Which of the suspects is left after the further questions, and whether it is the only one.

use super::suspects::{BY_CHANCE, HALF, Suspect};
use super::{ENOUGH, same};
use crate::diagnose::evidence::{Evidence, Item};
use std::collections::BTreeSet;

/// Different answers that tell a guess from others.
const VARIED: usize = 3;

/// Wrong answers after which who explains all of them is told for certain, where no other explanation is asked about.
pub const SURE: usize = 16;

/// Of this many estimates, one may be off by more than chance makes most.
const MANY: usize = 20;

/// The share of all wrong answers that two mistakes explain together.
const NEARLY_ALL: f64 = 0.95;

/// Those who are left, the first of whom is told if it is the only one.
pub struct Left<'s, 'a> {
    /// One of the exercise's own mistakes before a guess, and one before two, which is simpler.
    pub all: Vec<&'s Suspect<'a>>,
}

/// Who of the suspects gives the answers to the `further` questions, and is not denied by one of `all`; none if too few are wrong.
pub fn left<'s, 'a>(
    suspects: &'s [Suspect<'a>],
    further: &Evidence<'_>,
    all: &Evidence<'_>,
) -> Left<'s, 'a> {
    if further.wrong < ENOUGH {
        return Left { all: Vec::new() };
    }
    let suspects = suspects.iter();
    let mut left: Vec<_> = suspects
        .filter(|suspect| gives(suspect, further, all))
        .collect();
    // What a judge takes for the answers is not the mistake, where something else gives them to the last digits.
    let sharp = |suspect: &Suspect<'_>| {
        let answer = |k: usize| (suspect.answer)(&further.items[k].question);
        further.score(1.0, answer).map_or(0, |score| score.sharp)
    };
    if left.iter().any(|suspect| sharp(suspect) == further.wrong) {
        left.retain(|suspect| 2 * sharp(suspect) >= further.wrong);
    }
    // Who makes two mistakes does not make one of them alone.
    let together = left.clone();
    left.retain(|one| !together.iter().any(|two| one.is_half_of(two)));
    left.sort_by_key(|suspect| (suspect.is_guess, suspect.is_two()));
    Left { all: left }
}

/// Whether a suspect gives the answers to the further questions, and no answer of all denies it.
fn gives(suspect: &Suspect<'_>, further: &Evidence<'_>, all: &Evidence<'_>) -> bool {
    let most_missed = if further.is_rough() {
        further.wrong / MANY
    } else {
        0
    };
    let share = 1.0 - most_missed as f64 / further.wrong as f64;
    let score = further.score(share, |k| (suspect.answer)(&further.items[k].question));
    // Of many pairs, one or another explains half of all.
    let share = if suspect.is_two() { NEARLY_ALL } else { HALF };
    let in_all = all.score(share, |k| (suspect.answer)(&all.items[k].question));
    let (Some(score), Some(in_all)) = (score, in_all) else {
        return false;
    };
    // Yes and no are those of many guesses; the other ways to misread a question are suspects, too.
    let is_sharp = 2 * score.sharp >= score.explained;
    let is_varied = different(&further.items[..further.wrong]) >= VARIED;
    let is_sure = further.wrong >= SURE && different(&further.items) > 1;
    let is_told = !suspect.is_guess || is_sharp && (is_varied || suspect.is_read && is_sure);
    is_told && score.missed <= most_missed && in_all.contradicted == 0 && !in_all.is_doubtful
}

/// How many different answers there are.
fn different(items: &[Item]) -> usize {
    let texts: BTreeSet<_> = items.iter().map(|item| item.text.trim()).collect();
    texts.len()
}

impl<'s, 'a> Left<'s, 'a> {
    /// The first, if all others are the same: these two in another order, or what has the same answers and explains no more.
    pub fn only(&self, further: &Evidence<'_>) -> Option<&'s Suspect<'a>> {
        let (first, others) = self.all.split_first()?;
        // What cannot be told from an own mistake is the same in other words; what cannot be told from a guess is another guess.
        let is_same = |other: &Suspect<'_>| {
            let mut items = further.items.iter();
            !first.is_guess
                && items.all(|item| {
                    let [one, other] =
                        [first, other].map(|suspect| (suspect.answer)(&item.question));
                    same(one.as_deref(), other.as_deref())
                })
        };
        let explains_more = |other: &Suspect<'_>| {
            other.is_two() && other.score.explained > first.score.explained + BY_CHANCE
        };
        let is_named_so = |other: &Suspect<'_>| {
            other.is_two() && other.name == first.name && other.second() == first.second()
        };
        let mut others = others.iter();
        others
            .all(|other| is_named_so(other) || is_same(other) && !explains_more(other))
            .then_some(*first)
    }

    /// Whether one of this name is left.
    pub fn has(&self, name: &str) -> bool {
        self.all.iter().any(|suspect| suspect.name == name)
    }
}
