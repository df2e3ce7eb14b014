//! Answers of which many are right: a mistake shows in their traits, costs or shares of a distribution, over all cases together.

mod distance;

use super::evidence::{Evidence, Item};
use super::fit;
use super::function::COMMON;
use super::misread::Misreading;
use super::pairs::{SLOW, Upon};
use super::search::{golden, misread};
use super::slips::{RANK, Slipped, each_slip, slipped};
use super::{Beside, Diagnosis, MOST, SOME, special};
use crate::each::{each, found_of_each};
use distance::{Distance, PROMISING, Traits};
use std::iter;

/// Of what explains next to all, this share of the distance is left at most.
const NEAR: f64 = 0.2;

/// Of what is certain, only this share: another mistake of estimates may come nearer than `NEAR` by chance.
const SURE: f64 = 0.1;

/// Who gives other answers than a mistake, but their traits, leaves this share of the distance at most, and so do two mistakes that are told for
/// certain: of all pairs, one comes nearer than `SURE` by chance.
const EXACT: f64 = 0.03;

/// This share is nothing.
const NOTHING: f64 = 1e-3;

/// A mistake spoils no more right answers than this for each wrong one: what is next to wrong is called right by a judge's tolerance.
const CONTRADICTED: usize = 3;

/// Of the answers that are wrong by a mistake, one in this number has the flaw that the student's has: of several flaws chance decides which is told.
const SOME_ALIKE: usize = 4;

/// Of what is told for certain, a question in which it changes nothing is answered wrongly for another reason, such as a tie, less than once in this
/// number.
const SELDOM: usize = 12;

/// The number of wrong answers that a slip is tried on before it is tried on all.
const PROBE: usize = 4;

/// A slip of a higher [`Slipped::rank`] is not told by traits alone: among all the rare ones, one comes near by chance.
const RAREST: u32 = RANK + COMMON + 2;

/// The rank of a slip: behind the exercise's own mistakes, and before all guesses about answers as a whole.
const SLIP: u32 = 1;

/// Of what one mistake explains, this share of the distance may be left before two are tried.
const ALMOST: f64 = 0.05;

/// The rank of two mistakes: behind one.
const PAIR: u32 = 2;

/// Mistakes that are tried two by two: those whose answers are nearest to the student's, …
const CANDIDATES: usize = 10;

/// … and fewer where answers take long.
const SLOW_CANDIDATES: usize = 5;

/// Two mistakes leave at most this share of what one leaves.
const TWICE_AS_NEAR: f64 = 0.5;

/// A mistake that was considered.
struct Considered {
    /// What of the distance is left.
    rest: f64,
    /// What of it is left beyond chance.
    left: f64,
    rank: u32,
    name: String,
    hint: String,
    /// A mistake that is made upon it.
    then: Option<(String, String)>,
}

impl Considered {
    /// The names of its mistakes, in the order of the alphabet: two are the same two, whichever is made upon the other.
    fn names(&self) -> Vec<&str> {
        let then = self.then.iter().map(|(name, _)| name.as_str());
        let mut names: Vec<_> = iter::once(self.name.as_str()).chain(then).collect();
        names.sort_unstable();
        names
    }

    /// What one answers who makes it, if it is one of the exercise's own, or two of them.
    fn answer(&self, evidence: &Evidence<'_>, item: usize) -> Option<Vec<f64>> {
        let own = |name: &str| evidence.examiner.mistake_called(name);
        let first = own(&self.name)?;
        match &self.then {
            None => evidence.mistaken(first, item),
            Some((then, _)) => Upon::new(first, own(then)?).answer(evidence, item),
        }
    }

    /// The wrong answers to questions in which it changes nothing: it cannot have made them wrong.
    fn unchanged(&self, evidence: &Evidence<'_>) -> Vec<usize> {
        let is_unchanged = |k: &usize| {
            let item = &evidence.items[*k];
            let traits = |answer: &[f64]| evidence.examiner.traits(&item.question, answer);
            let answer = self.answer(evidence, *k);
            let answer = answer.filter(|answer| evidence.is_right(item, answer));
            answer.is_some_and(|answer| traits(&answer) == traits(item.golden()))
        };
        (0..evidence.wrong).filter(is_unchanged).collect()
    }

    /// What is said of it, where it explains this number of wrong answers; for certain if it `is_certain`.
    fn told(&self, evidence: &Evidence<'_>, explained: usize, is_certain: bool) -> Diagnosis {
        let one = |name: &str, hint: &str, beside| Diagnosis {
            name: name.to_owned(),
            hint: hint.to_owned(),
            part: None,
            certain: false,
            explained,
            wrong: evidence.wrong,
            further: 0,
            shown: None,
            beside,
            also: Vec::new(),
        };
        let mut then = self.then.iter();
        let then = then
            .next()
            .map(|(name, hint)| one(name, hint, Beside::Together));
        Diagnosis {
            certain: is_certain,
            also: then.into_iter().collect(),
            ..one(&self.name, &self.hint, Beside::Apart)
        }
    }
}

/// What the nearest leaves of the distance.
fn nearest(found: &[Considered]) -> f64 {
    let rests = found.iter().map(|one| one.rest);
    rests.fold(f64::INFINITY, f64::min)
}

/// A mistake whose answers have the same traits as the student's.
pub struct Likely {
    /// What is said of it.
    pub diagnosis: Diagnosis,
    /// Whether it is a mistake in the function, and not only what its answers look like.
    pub is_cause: bool,
    /// The share of the distance that is left, beyond what chance leaves.
    left: f64,
    /// Whether nothing is, and nothing else comes as near. Of two mistakes at once that makes nobody certain before further questions: of many pairs
    /// one comes near by chance.
    pub is_alone: bool,
}

impl Likely {
    /// Whether next to nothing is left unexplained …
    pub fn is_near(&self) -> bool {
        self.left < NEAR
    }

    /// … or nothing but what chance leaves.
    pub fn is_exact(&self) -> bool {
        self.left < EXACT
    }
}

/// All mistakes whose answers have about the traits of the student's: single ones, and two at once where no single one comes near.
/// Without ways to misread a question, the exercise's own mistakes only.
fn considered(
    evidence: &Evidence<'_>,
    readings: Option<&[Misreading]>,
    traits: &Traits<'_, '_>,
    whole: &Distance,
) -> Vec<Considered> {
    let examiner = evidence.examiner;
    let right = golden(evidence);
    let few = traits.few();
    let few = few.and_then(|few| {
        let whole = traits.distance_among(&few, &|i| right[i].clone())?;
        Some((few, whole))
    });
    let consider = |rank, name: &str, hint: &str, answers: &dyn Fn(usize) -> Option<Vec<f64>>| {
        if let Some((few, whole)) = &few {
            let rest = traits.distance_among(few, answers)?;
            if !rest.promises(whole) {
                return None;
            }
        }
        let rest = traits.distance(answers);
        let rest = rest.filter(|rest| rest.explains(whole))?;
        Some(Considered {
            rest: rest.norm(),
            left: rest.beyond_chance(),
            rank,
            name: name.to_owned(),
            hint: hint.to_owned(),
            then: None,
        })
    };
    let mut found: Vec<Considered> = Vec::new();
    let mistakes: Vec<_> = examiner.mistakes().into_iter().enumerate().collect();
    found.extend(found_of_each(&mistakes, |&(i, (name, hint))| {
        consider(0, name, hint, &|k| evidence.mistaken(i, k))
    }));
    // To a single wrong answer something comes near by chance, and so it does to answers that are wrong all together only.
    let by_themselves = evidence.wrong > 1 && evidence.are_wrong_by_themselves();
    if let Some(readings) = readings {
        let mut made = special::explanations(evidence, &right);
        made.extend(fit::factors(evidence, &right));
        made.extend(fit::functions(evidence, &right));
        found.extend(found_of_each(&made, |one| {
            let answer = |k: usize| one.answers[k].clone();
            consider(one.rank, &one.name, &one.hint, &answer)
        }));
        found.extend(found_of_each(readings, |reading| {
            let answer = |k| misread(evidence, reading, k);
            consider(reading.rank, &reading.name, &reading.hint, &answer)
        }));
        if !evidence.is_judged() && examiner.limits().effort <= 1 && by_themselves {
            let by_steps = each_slip(evidence, &promising(evidence), |slip| {
                let answer = |k: usize| slip.answer_to(evidence, k);
                consider(SLIP, &slip.name, &slip.hint, &answer)
            });
            found.extend(by_steps.into_iter().flatten());
        }
    }
    let most = nearest(&found);
    if by_themselves && most > ALMOST * whole.norm() {
        let pairs = two(evidence, traits, whole).into_iter();
        found.extend(pairs.filter(|pair| pair.rest < TWICE_AS_NEAR * most));
    }
    found
}

/// The mistake whose answers have the same traits as the student's; none if the exercise has none, or no mistake stands out.
/// Without ways to misread a question, only the exercise's own are considered.
pub fn search(evidence: &Evidence<'_>, readings: Option<&[Misreading]>) -> Option<Likely> {
    let examiner = evidence.examiner;
    let traits = Traits::of(evidence)?;
    let right = golden(evidence);
    let whole = traits.distance(&|i| right[i].clone())?;
    let found = considered(evidence, readings, &traits, &whole);
    let nearest = nearest(&found);
    // What is as near as the nearest, but for chance: the commonest first.
    let errors = whole.chance();
    let near = |one: &&Considered| one.rest <= 1.3 * nearest + 0.5 * errors + 1e-6;
    let mut near: Vec<_> = found.iter().filter(near).collect();
    near.sort_by(|a, b| a.rank.cmp(&b.rank).then(a.rest.total_cmp(&b.rest)));
    let own = |name: &str| examiner.mistake_called(name);
    near.retain(|one| {
        let contradicted = |number| is_contradicted(evidence, number) || !shows(evidence, number);
        one.then.is_some() || !own(&one.name).is_some_and(contradicted)
    });
    let best = *near.first()?;
    let Considered {
        rest,
        rank,
        name,
        then,
        ..
    } = best;
    let left = best.left / whole.norm();
    // Costs and counts may be alike by chance where the answers are not: of an own mistake the share of answers that are its own tells.
    let gives = |number: usize| {
        let gives = |k: &usize| {
            let answer = evidence.mistaken(number, *k);
            answer.is_some_and(|answer| evidence.explains(*k, &answer))
        };
        let given = (0..evidence.wrong).filter(gives).count();
        given as f64 / evidence.wrong as f64
    };
    let goes_the_same_way =
        then.is_none() && evidence.right_ones_tell() && evidence.goes_the_same_way();
    let given_by = |one: &Considered| own(&one.name).map_or(0.0, gives);
    let given = own(name).filter(|_| goes_the_same_way).map(gives);
    let is_given = given.is_some_and(|given| given >= MOST)
        || then.is_none() && !evidence.is_rough() && given_by(best) >= MOST;
    // What leaves nothing leaves nothing to chance.
    let errors = if *rest <= NOTHING * whole.norm() {
        0.0
    } else {
        errors
    };
    let is_rival = |other: &&Considered| {
        // A slip that comes exactly as near is the same mistake in other words, and so is, beside one of the exercise's own, all that comes
        // as near but for chance. Where the answers are given to the last digits, who does not give them is no rival.
        let is_the_same = other.rank == SLIP && other.rest == *rest || *rank == 0 && other.rank > 0;
        let gives_less = || own(&other.name).is_some() && given_by(other) < MOST * given_by(best);
        // Of many pairs some come near, but few leave nothing that chance does not leave.
        let most = if then.is_some() { EXACT } else { SURE };
        let is_worse = left < EXACT && other.left > most * whole.norm();
        other.names() != best.names()
            && other.rest < 2.0 * rest + 2.0 * errors
            && !is_worse
            && !is_the_same
            && !(is_given && gives_less())
    };
    let mut rivals = found.iter().filter(is_rival);
    let given = given.unwrap_or(1.0);
    // Simple questions have one answer, whichever way is gone: who makes the mistake on another way gives none of its answers, but
    // their traits, to which no other mistake comes near.
    let stands_out = *rank == 0 && left < NEAR && rivals.clone().all(|other| other.rank > SLIP);
    if given < SOME && !stands_out {
        return None;
    }
    // All together may have the mean of what none of them is: an estimate is about what a mistake makes of its question.
    let is_rough = then.is_none() && evidence.is_rough();
    let estimates = own(name).filter(|_| is_rough).map(gives);
    let unchanged = best.unchanged(evidence);
    let is_alone = estimates.is_none_or(|share| share >= MOST)
        && SELDOM * unchanged.len() < evidence.wrong
        && rivals.next().is_none()
        && left < SURE
        && (then.is_none() && given >= MOST || left < EXACT);
    let explained = evidence.wrong - unchanged.len();
    // A slip is one of hundreds, of which one comes near by chance: it is told for certain only if it leaves nothing at all.
    let is_one = *rank == 0 || *rank == SLIP && *rest <= NOTHING * whole.norm();
    let mut diagnosis = best.told(evidence, explained, is_one && is_alone);
    let rest = evidence.only(&unchanged);
    let rest = rest.and_then(|rest| search(&rest, readings).filter(|rest| rest.is_cause));
    diagnosis.also.extend(rest.map(|rest| Diagnosis {
        certain: false,
        ..rest.diagnosis
    }));
    Some(Likely {
        diagnosis,
        is_cause: *rank <= PAIR,
        left,
        is_alone,
    })
}

/// Whether right answers contradict an own mistake: what is much wrong in few answers has the mean of what is a little wrong in many.
fn is_contradicted(evidence: &Evidence<'_>, number: usize) -> bool {
    let spoils = |k: &usize| {
        let answer = evidence.mistaken(number, *k);
        answer.is_some_and(|answer| !evidence.is_right(&evidence.items[*k], &answer))
    };
    let right = evidence.wrong..evidence.items.len();
    right.filter(spoils).count() > CONTRADICTED * evidence.wrong
}

/// Whether half of the wrong answers would be wrong by an own mistake, too, and enough of them have the same flaw, where they have one: what makes
/// few answers wrong has about the traits of right ones, and what is no tree has few traits.
fn shows(evidence: &Evidence<'_>, number: usize) -> bool {
    let examiner = evidence.examiner;
    let flaws = examiner.flaws();
    let complaint = |item: &Item, answer: &[f64]| {
        let verdict = examiner.compare(&item.question, item.golden(), answer);
        let why = examiner.complaint(&item.question, item.golden(), answer, verdict.err()?);
        Some(flaws.iter().position(|flaw| why.contains(flaw.complaint)))
    };
    let (mut shown, mut alike) = (0, 0);
    for (k, item) in evidence.items[..evidence.wrong].iter().enumerate() {
        let answer = evidence.mistaken(number, k);
        let Some(flaw) = answer.and_then(|answer| complaint(item, &answer)) else {
            continue;
        };
        shown += 1;
        let theirs = complaint(item, &item.got);
        alike += usize::from(theirs.is_none_or(|theirs| theirs == flaw));
    }
    2 * shown >= evidence.wrong && SOME_ALIKE * alike >= shown
}

/// Two of the exercise's own mistakes, one made upon the other, whose answers have the same traits as the student's, and are much nearer to
/// these than the answers of each of the two.
fn two(evidence: &Evidence<'_>, traits: &Traits<'_, '_>, whole: &Distance) -> Vec<Considered> {
    let Some(probe) = evidence.probe(PROBE) else {
        return Vec::new();
    };
    let Some(few) = Traits::of(&probe) else {
        return Vec::new();
    };
    let right = golden(&probe);
    let Some(from_right) = few.distance(&|k| right[k].clone()) else {
        return Vec::new();
    };
    let count = evidence.examiner.mistakes().len();
    let mistakes: Vec<_> = (0..count).collect();
    let alone = found_of_each(&mistakes, |&i| {
        Some((i, few.distance(&|k| probe.mistaken(i, k))?.norm()))
    });
    let mut near: Vec<_> = alone.collect();
    near.sort_by(|a, b| a.1.total_cmp(&b.1));
    let is_slow = evidence.examiner.limits().effort >= SLOW;
    near.truncate(if is_slow { SLOW_CANDIDATES } else { CANDIDATES });
    let near = each(&near, |&(mistake, _)| {
        let rest = traits.distance(&|k| evidence.mistaken(mistake, k));
        (mistake, rest.map_or(f64::INFINITY, |rest| rest.norm()))
    });
    let pairs = near.iter().flat_map(|one| {
        let others = near.iter().filter(|other| other.0 != one.0);
        others.map(|other| [*one, *other])
    });
    let pairs: Vec<_> = pairs.collect();
    let found = found_of_each(&pairs, |&[(first, one), (second, other)]| {
        let upon = Upon::new(first, second);
        let rest = few.distance(&|k| upon.answer(&probe, k));
        let promises = rest.is_some_and(|rest| rest.norm() <= PROMISING * from_right.norm());
        if !promises || !upon.is_made() {
            return None;
        }
        let most = (TWICE_AS_NEAR * one.min(other)).min(SURE * whole.norm());
        let rest = traits.distance(&|k| upon.answer(evidence, k));
        let rest = rest.filter(|rest| rest.norm() < most && rest.explains(whole))?;
        let [(name, hint), then] = upon.told(evidence);
        Some(Considered {
            rest: rest.norm(),
            left: rest.beyond_chance(),
            rank: PAIR,
            name,
            hint,
            then: Some(then),
        })
    });
    found.collect()
}

/// The slips that make the first wrong answers likely.
fn promising(evidence: &Evidence<'_>) -> Vec<Slipped> {
    let Some(probe) = evidence.probe(PROBE) else {
        return Vec::new();
    };
    let Some(traits) = Traits::of(&probe) else {
        return Vec::new();
    };
    let right = golden(&probe);
    let Some(whole) = traits.distance(&|i| right[i].clone()) else {
        return Vec::new();
    };
    let is_promising = |slip: &Slipped| {
        let rest = traits.distance(&|k| slip.answer_to(&probe, k));
        rest.is_some_and(|rest| rest.norm() <= PROMISING * whole.norm())
    };
    let mut slips = slipped(&probe);
    slips.retain(|slip| slip.rank <= RAREST);
    slips.sort_by_key(|slip| slip.rank);
    let are_promising = each_slip(evidence, &slips, is_promising);
    let with = slips.into_iter().zip(are_promising);
    with.filter_map(|(slip, promises)| promises.then_some(slip))
        .collect()
}
