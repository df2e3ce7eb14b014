//! Explanations by two mistakes, one after the other or beside each other.

use super::evidence::{Evidence, Scope, Score};
use super::fit::{self, Answers};
use super::found::Found;
use super::misread::Misreading;
use super::search::misread;
use super::slips::slipped;
use super::{COMMON, MOST, TELLS};
use crate::attempt::attempt;
use crate::each::{each, found_of_each};
use std::cell::Cell;

/// Wrong answers that an explanation is tried on before it is tried on all.
const PROBE: usize = 8;

/// The share of what a pair must give of all wrong answers that it must give of the probe.
const PROMISING: f64 = 0.9;

/// The effort of an answer from which on few pairs are tried.
pub const SLOW: usize = 10;

/// Ways to misread a question that are tried in pairs, the likeliest first.
const PAIRS: usize = 60;

/// Steps and decisions that are gone in all, when slips are tried two by two.
const STEPS: usize = 2_000_000;

/// The rank of a mistake, and of what is made of its answers …
const AFTER: u32 = 40;

/// … of two of the exercise's own mistakes of which one is made upon the other …
const UPON: u32 = 42;

/// … of two that do not meddle with each other …
pub const OWN: u32 = 44;

/// … of one of the exercise's own mistakes in a question that was misread …
const MISREAD: u32 = 45;

/// … and of two guesses.
const GUESSED: u32 = 60;

/// A way to misread a question of this rank is too rare for what is made of its answers.
const RARE: u32 = 17;

/// The share of the probe that guesses in pairs must give.
const NEARLY_ALL: f64 = 0.99;

/// What is answered to the question of an item.
type Answer<'a> = &'a dyn Fn(usize) -> Option<Vec<f64>>;

/// Explanations by two steps of one way that go wrong, or by one of them and a question that was misread, where no single one explains the
/// answers.
pub fn both(evidence: &Evidence<'_>, readings: &[Misreading], found: &mut Vec<Found>) {
    /// Wrong answers that tell whether a pair is worth a look at all of them.
    const FEW: usize = 3;
    let Some(probe) = evidence.probe(PROBE) else {
        return;
    };
    let is_all = evidence.scope == Scope::Whole && evidence.is_judged();
    if !is_all || probe.wrong < FEW || !probe.tells_much() {
        return;
    }
    let mut slips = slipped(evidence);
    // Of decisions and loops there are few.
    slips.sort_by_key(|slip| (slip.is_of_a_value(), slip.rank));
    let Some(first) = slips.first() else { return };
    let few = [0, evidence.wrong / 2, evidence.wrong - 1];
    let question = |k: usize| &evidence.items[k].question;
    let lengths = few.map(|k| first.length(question(k)));
    let length = lengths.into_iter().max().unwrap_or_default().max(1);
    let consider = |names: [(&str, &str); 2], rank, answer: Answer<'_>| {
        let answer = |k: usize| answer(k).filter(|answer| !answer.iter().any(|v| v.is_nan()));
        let explains = |k: &usize| answer(*k).is_some_and(|answer| evidence.explains(*k, &answer));
        if !few.iter().all(explains) {
            return None;
        }
        let answers: Answers = (0..evidence.items.len()).map(answer).collect();
        let score = evidence.score(MOST, |k| answers[k].clone())?;
        let pair = pair(names, GUESSED + rank, 0, score, answers);
        // In a few cases another way around a division by 0 decides.
        (score.contradicted == 0 && pair.is_nearly_complete()).then_some(pair)
    };
    let asked = evidence.examiner.asked().question;
    let common: Vec<_> = readings.iter().filter(|r| r.rank <= COMMON).collect();
    let most = STEPS / (length * common.len().max(1));
    let misread = each(&slips[..most.min(slips.len())], |slip| {
        let with = common.iter().filter_map(|reading| {
            let answer = |k: usize| slip.answer(&reading.read_or_not(asked, question(k)));
            let names = [(&*reading.name, &*reading.hint), (&*slip.name, &*slip.hint)];
            consider(names, reading.rank + slip.rank, &answer)
        });
        with.collect::<Vec<_>>()
    });
    found.extend(misread.into_iter().flatten());
    slips.truncate((2 * STEPS / length).isqrt());
    let numbers: Vec<_> = (0..slips.len()).collect();
    let twice = each(&numbers, |&i| {
        let one = &slips[i];
        let others = slips[..i].iter().filter(|other| one.goes_with(other));
        let with = others.filter_map(|other| {
            let names = [other, one].map(|slip| (&*slip.name, &*slip.hint));
            let answer = |k: usize| one.answer_with(other, question(k));
            consider(names, one.rank + other.rank, &answer)
        });
        with.collect::<Vec<_>>()
    });
    found.extend(twice.into_iter().flatten());
}

/// Two mistakes, told by their names and hints.
pub fn pair(
    names: [(&str, &str); 2],
    rank: u32,
    fitted: u32,
    score: Score,
    answers: Answers,
) -> Found {
    let [(name, hint), then] = names.map(|(name, hint)| (name.to_owned(), hint.to_owned()));
    Found {
        name,
        hint,
        then: Some(then),
        rival: None,
        rank,
        fitted,
        score,
        answers,
        ties: 0,
    }
}

/// What two mistakes make of a right answer together.
pub type Together = fn(right: f64, one: f64, other: f64) -> f64;

/// Each changes a summand of its own, or a factor of its own.
pub const TOGETHER: [Together; 2] = [
    |right, one, other| one + other - right,
    |right, one, other| {
        if right == 0.0 {
            one + other
        } else {
            one * other / right
        }
    },
];

/// The answer of two mistakes that do not meddle with each other: where one does not show, it is the other's.
pub fn of_two(right: &[f64], one: &[f64], other: &[f64], together: Together) -> Option<Vec<f64>> {
    if one == right {
        return Some(other.to_vec());
    }
    if other == right {
        return Some(one.to_vec());
    }
    let is_alike = one.len() == right.len() && other.len() == right.len();
    let each = right.iter().zip(one.iter().zip(other));
    is_alike.then(|| {
        each.map(|(right, (one, other))| together(*right, *one, *other))
            .collect()
    })
}

/// Explanations by two of the exercise's own mistakes, each in another summand, factor or branch.
pub fn composed(evidence: &Evidence<'_>, found: &mut Vec<Found>) {
    let examiner = evidence.examiner;
    let Some(probe) = evidence.probe(PROBE) else {
        return;
    };
    if probe.wrong < 3 || !probe.tells_much() || !evidence.is_judged() {
        return;
    }
    let mistakes = examiner.mistakes();
    let answers = |i: usize, of: &Evidence<'_>| -> Answers {
        (0..of.items.len()).map(|k| of.mistaken(i, k)).collect()
    };
    let few: Vec<_> = (0..mistakes.len()).map(|i| answers(i, &probe)).collect();
    let made = |of: &Evidence<'_>, one: &Answers, other: &Answers, together, k: usize| {
        let (one, other) = (one[k].as_ref()?, other[k].as_ref()?);
        of_two(of.items[k].golden(), one, other, together)
    };
    for (i, one) in few.iter().enumerate() {
        for (j, other) in few[..i].iter().enumerate() {
            for together in TOGETHER {
                let promises = probe.score(NEARLY_ALL, |k| made(&probe, one, other, together, k));
                if promises.is_none() {
                    continue;
                }
                let (one, other) = (answers(i, evidence), answers(j, evidence));
                let answers: Answers = (0..evidence.items.len())
                    .map(|k| made(evidence, &one, &other, together, k))
                    .collect();
                let Some(score) = evidence.score(MOST, |k| answers[k].clone()) else {
                    continue;
                };
                found.push(pair([mistakes[j], mistakes[i]], OWN, 0, score, answers));
            }
        }
    }
}

/// One of the exercise's own mistakes made upon another.
pub struct Upon {
    pair: [usize; 2],
    /// Whether the first is made of anything that the second changes, as far as they were asked.
    is_made: Cell<bool>,
}

impl Upon {
    /// The first mistake upon the second, by their numbers.
    pub fn new(first: usize, second: usize) -> Self {
        Self {
            pair: [first, second],
            is_made: Cell::new(false),
        }
    }

    /// What is answered to an item's question; none if one of the two stops with an error.
    pub fn answer(&self, evidence: &Evidence<'_>, item: usize) -> Option<Vec<f64>> {
        self.answer_to(evidence, &evidence.items[item].question)
    }

    /// The same for any question.
    fn answer_to(&self, evidence: &Evidence<'_>, question: &[f64]) -> Option<Vec<f64>> {
        let [first, second] = self.pair;
        let both = attempt(|| evidence.examiner.mistakes_answer(first, second, question));
        let (answer, is_made) = both.flatten()?;
        self.is_made.set(self.is_made.get() || is_made);
        Some(answer)
    }

    /// Whether the first is made of anything that the second changes, in what was asked so far: else it is told alone.
    pub fn is_made(&self) -> bool {
        self.is_made.get()
    }

    /// The names and the hints of both, in the order in which they are told.
    pub fn told(&self, evidence: &Evidence<'_>) -> [(String, String); 2] {
        let mistakes = evidence.examiner.mistakes();
        let told = |i: usize| (mistakes[i].0.to_owned(), mistakes[i].1.to_owned());
        evidence.in_order(self.pair).map(told)
    }
}

/// Explanations by one of the exercise's own mistakes made upon another.
pub fn made_upon(evidence: &Evidence<'_>, found: &mut Vec<Found>) {
    if evidence.scope != Scope::Whole || evidence.tells_in_all() < TELLS {
        return;
    }
    let Some(probe) = evidence.probe(PROBE).filter(|probe| probe.wrong >= 3) else {
        return;
    };
    // Where single answers say little more than yes or no, a pair must give every wrong one.
    let share = if probe.tells_much() { MOST } else { 1.0 };
    let mistakes: Vec<_> = (0..evidence.examiner.mistakes().len()).collect();
    // Where answers take long, one of the two must give half of the answers alone.
    let is_slow = evidence.examiner.limits().effort >= SLOW;
    let gives = |mistake: &usize| {
        let gives = |k: &usize| {
            let alone = probe.mistaken(*mistake, *k);
            alone.is_some_and(|alone| probe.explains(*k, &alone))
        };
        !is_slow || 2 * (0..probe.wrong).filter(gives).count() >= probe.wrong
    };
    let gives = each(&mistakes, gives);
    let pairs = mistakes.iter().flat_map(|first| {
        let others = mistakes.iter().filter(move |second| *second != first);
        others.map(|second| [*first, *second])
    });
    let pairs: Vec<_> = pairs
        .filter(|pair| pair.iter().any(|one| gives[*one]))
        .collect();
    found.extend(found_of_each(&pairs, |&[first, second]| {
        let upon = Upon::new(first, second);
        let promises = probe.score(PROMISING * share, |k| upon.answer(&probe, k));
        if promises.is_none() || !upon.is_made() {
            return None;
        }
        let answers: Answers = (0..evidence.items.len())
            .map(|k| upon.answer(evidence, k))
            .collect();
        let score = evidence.score(share, |k| answers[k].clone())?;
        let told = upon.told(evidence);
        let names = [0, 1].map(|i| (&*told[i].0, &*told[i].1));
        // Of two of which one undoes a part of the other, the words say more than what is so: two that go in any order come first.
        let back = Upon::new(second, first);
        let differs = |k: &usize| upon.answer(&probe, *k) != back.answer(&probe, *k);
        let differ = (0..probe.items.len()).filter(differs).count();
        let rank = UPON + u32::from(differ > 0 && back.is_made());
        let mut pair = pair(names, rank, 0, score, answers);
        pair.decide_ties(evidence, &|question| upon.answer_to(evidence, question));
        Some(pair)
    }));
}

/// The first of two mistakes.
enum First<'a> {
    /// One of the exercise's own, by its number.
    Own(usize),
    /// A question that was misread.
    Read(&'a Misreading),
}

impl<'a> First<'a> {
    /// The exercise's own mistakes, and the ways to misread its questions of which not too much is needed.
    fn all(evidence: &Evidence<'_>, readings: &'a [Misreading]) -> Vec<Self> {
        let own = (0..evidence.examiner.mistakes().len()).map(First::Own);
        let read = readings.iter().filter(|reading| reading.rank < RARE);
        own.chain(read.map(First::Read)).collect()
    }

    /// Its name and its hint.
    fn words<'b>(&'b self, mistakes: &[(&'b str, &'b str)]) -> (&'b str, &'b str) {
        match self {
            First::Own(number) => mistakes[*number],
            First::Read(reading) => (&reading.name, &reading.hint),
        }
    }

    fn rank(&self) -> u32 {
        match self {
            First::Own(_) => 0,
            First::Read(reading) => reading.rank,
        }
    }

    /// What is answered to each item's question, in the order in which answers are compared.
    fn answers(&self, evidence: &Evidence<'_>) -> Answers {
        let answer = |k: usize| match self {
            First::Own(number) => evidence.mistaken(*number, k),
            First::Read(reading) => misread(evidence, reading, k),
        };
        let in_form = |k: usize| {
            let question = &evidence.items[k].question;
            Some(evidence.canonical(question, &answer(k)?))
        };
        (0..evidence.items.len()).map(in_form).collect()
    }
}

/// Explanations by two mistakes, one after the other: what is made of the answer of another mistake, or of a question misread.
pub fn pairs(evidence: &Evidence<'_>, readings: &[Misreading], found: &mut Vec<Found>) {
    let Some(probe) = evidence.probe(PROBE) else {
        return;
    };
    if probe.wrong < 3 || !probe.tells_much() {
        return;
    }
    let mistakes = evidence.examiner.mistakes();
    let firsts = First::all(evidence, readings);
    let made = each(&firsts, |first| {
        let few = first.answers(&probe);
        let changed = few
            .iter()
            .zip(&probe.items)
            .filter(|(few, item)| few.as_deref() != Some(item.golden()))
            .count();
        if 2 * changed < probe.wrong {
            return Vec::new();
        }
        let mut found = Vec::new();
        for second in fit::explanations(&probe, &few, false) {
            if probe
                .score(NEARLY_ALL, |k| second.answers[k].clone())
                .is_none()
            {
                continue;
            }
            // The number that fits is that of all wrong answers.
            let again = fit::explanations(evidence, &first.answers(evidence), false);
            for again in again.into_iter().filter(|again| again.name == second.name) {
                let Some(score) = evidence.score(MOST, |k| again.answers[k].clone()) else {
                    continue;
                };
                let names = [first.words(&mistakes), (&*again.name, &*again.hint)];
                let rank = AFTER + first.rank() + again.rank;
                found.push(pair(names, rank, again.fitted, score, again.answers));
            }
        }
        found
    });
    found.extend(made.into_iter().flatten());
    // Who draws numbers of his own has other answers than any pair.
    if evidence.is_judged() {
        misread_twice(evidence, &probe, readings, found);
    }
}

/// Explanations by a question that was misread, and by one of the exercise's own mistakes or another way to misread it.
fn misread_twice(
    evidence: &Evidence<'_>,
    probe: &Evidence<'_>,
    readings: &[Misreading],
    found: &mut Vec<Found>,
) {
    let examiner = evidence.examiner;
    let asked = examiner.asked();
    let mistakes = examiner.mistakes();
    let consider = |names: [(&str, &str); 2], rank, answer: &dyn Fn(&[f64]) -> Option<Vec<f64>>| {
        probe.score(NEARLY_ALL, |k| answer(&probe.items[k].question))?;
        let items = evidence.items.iter();
        let answers: Answers = items.map(|item| answer(&item.question)).collect();
        let score = evidence.score(MOST, |k| answers[k].clone())?;
        Some(pair(names, rank, 0, score, answers))
    };
    let mut common: Vec<_> = readings.iter().collect();
    common.sort_by_key(|reading| reading.rank);
    let numbers: Vec<_> = (0..common.len()).collect();
    let twice = each(&numbers, |&k| {
        let reading = common[k];
        let words = (&*reading.name, &*reading.hint);
        let own = mistakes.iter().enumerate().filter_map(|(i, mistake)| {
            let answer = |question: &[f64]| {
                let read = reading.read_or_not(asked.question, question);
                attempt(|| examiner.mistake_answers(i, &read))?
            };
            consider([*mistake, words], MISREAD + reading.rank, &answer)
        });
        let others = common[..k.min(PAIRS)].iter().filter(|_| k < PAIRS);
        let others = others.filter_map(|other| {
            let answer = |question: &[f64]| {
                let read = other.read_or_not(asked.question, question);
                let both = reading.read_or_not(asked.question, &read);
                attempt(|| examiner.right(&both))
            };
            let names = [(&*other.name, &*other.hint), words];
            consider(names, GUESSED + reading.rank + other.rank, &answer)
        });
        own.chain(others).collect::<Vec<_>>()
    });
    found.extend(twice.into_iter().flatten());
}
