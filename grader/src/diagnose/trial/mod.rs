//! The trial of a mistake that the answers leave in doubt: further questions on which it shows, and which tell it from others.
//!
//! Two wrong answers of yes or no are those of many mistakes. Who suspects one of them asks where it shows: if each further answer is as it
//! says, and no other suspect that says anything else is left, it is the one. Where answers are compared by their traits, further random
//! cases are asked, and the traits of all tell.

mod suspects;

use super::evidence::{Evidence, Item};
use super::misread::misreadings;
use super::search::{called, search};
use super::ties::{is_settled, leaves};
use super::{Beside, Diagnosis, spread};
use crate::examine::{Case, Examiner, visible_rng};
use crate::stable::is_stable;
use rand::RngExt;
use raybook::math::pcg::Pcg;
use raybook_workbook::kind::Kind;
use std::collections::BTreeSet;
use std::iter;
use suspects::{BY_CHANCE, HALF, Suspect, suspects};

/// Further questions on which the first suspect shows, at most.
const SHOWN: usize = 32;

/// Questions on which it shows that tell enough, and those by which it is told from each other suspect.
const ENOUGH: usize = 8;

/// Questions on which it shows that are looked for, where answers are estimates, which scatter.
const ENOUGH_ROUGH: usize = 24;

/// Questions on which it does not show.
const HIDDEN: usize = 8;

/// Questions after which none is looked for any longer on which it does not show: it shows in nearly all.
const ALL_SHOW: usize = 100;

/// Questions that are looked through, divided by the effort of an answer, …
const DRAWN: usize = 2000;

/// … and the fewest.
const FEWEST: usize = 40;

/// Different answers that tell a guess from others.
const VARIED: usize = 3;

/// Wrong answers after which who explains all of them is told for certain, where no other explanation is asked about.
const SURE: usize = 16;

/// Of this many estimates, one may be off by more than chance makes most.
const MANY: usize = 20;

/// The share of all wrong answers that two mistakes explain together.
const NEARLY_ALL: f64 = 0.95;

/// Rounds of random cases that are asked where answers are compared by their traits.
const ROUNDS: usize = 3;

/// What is suspected, and what is asked to know.
pub struct Trial<'a> {
    evidence: Evidence<'a>,
    told: &'a Diagnosis,
    /// What is told is the first of them. None where answers are compared by their traits, and where what is told is made of right answers, and
    /// has none to questions that were not asked.
    suspects: Vec<Suspect<'a>>,
    /// The further questions.
    pub cases: Vec<Case>,
}

impl<'a> Trial<'a> {
    /// A trial of what is told of these answers; none if nothing is in doubt, or nothing can be asked.
    pub fn new(
        examiner: &'a dyn Examiner,
        cases: &[Case],
        answers: &[(Option<String>, bool)],
        told: &'a Diagnosis,
    ) -> Option<Self> {
        let is_guess = examiner.mistake_called(&told.name).is_none();
        if told.part.is_some() || told.certain && (!is_guess || told.beside == Beside::Shown) {
            return None;
        }
        let evidence = Evidence::new(examiner, cases, answers);
        let rng = &mut visible_rng(&format!("{}, once more", cases.last()?.question));
        let mut suspects = suspects(&evidence, told);
        // Of two that are compared by their traits, none is convicted alone.
        let are_two = second(told).is_some() && !evidence.is_judged();
        if are_two && !suspects.iter().any(Suspect::is_two) {
            suspects.clear();
        }
        // A guess that is certain is told, unless one of the exercise's own says the same.
        if told.certain && suspects.iter().all(|suspect| suspect.is_guess) {
            return None;
        }
        let (suspects, cases) = match suspects.first() {
            Some(first) if evidence.is_judged() || first.name == told.name => {
                let cases = telling(&evidence, &suspects, rng);
                (suspects, cases)
            }
            _ => {
                let rounds = if evidence.is_judged() {
                    // Of half of the answers there is more to find than the same again.
                    let is_whole = told.explained == told.wrong && told.wrong >= ENOUGH;
                    usize::from(is_whole && told.beside == Beside::Apart)
                } else {
                    examiner.mistake_called(&told.name)?;
                    ROUNDS
                };
                let random = (0..rounds).map(|_| examiner.try_random_cases(rng));
                let random = random.collect::<Result<Vec<_>, _>>().ok()?;
                let cases: Vec<_> = random.into_iter().flat_map(|one| one.cases).collect();
                cases.first()?;
                (Vec::new(), cases)
            }
        };
        Some(Self {
            evidence,
            told,
            suspects,
            cases,
        })
    }

    /// Whether more questions may tell what these did not: traits of more answers scatter less.
    pub fn is_open(&self) -> bool {
        self.suspects.is_empty() && !self.evidence.is_judged()
    }

    /// What is told after it: for certain, if all is as one suspect says, and no right answer denied it before; else none. `cases` and
    /// `answers` are those of before, and behind them the further ones.
    pub fn verdict(&self, cases: &[Case], answers: &[(Option<String>, bool)]) -> Option<Diagnosis> {
        // Of all answers together it is known best how estimates scatter.
        let all = self.evidence.and_further(cases, answers);
        if self.suspects.is_empty() && self.evidence.is_judged() {
            return self.found_again(&all);
        }
        if self.suspects.is_empty() {
            let found = spread::search(&all, None).filter(|found| found.is_alone)?;
            let further = found.diagnosis.explained.checked_sub(self.told.explained)?;
            let told = names(self.told);
            let names = names(&found.diagnosis);
            // One of two explains all answers alone, as it turns out.
            let is_one_of_them = names.iter().all(|name| told.contains(name));
            let one = Diagnosis {
                name: found.diagnosis.name.clone(),
                hint: found.diagnosis.hint.clone(),
                ..self.told.clone()
            };
            return is_one_of_them.then(|| Diagnosis {
                further,
                ..self.convicted(&one, second(&found.diagnosis))
            });
        }
        let before = cases.len() - self.cases.len();
        let examiner = self.evidence.examiner;
        let evidence = Evidence::new(examiner, &self.cases, &answers[before..]);
        if evidence.wrong < ENOUGH {
            return None;
        }
        // Yes and no are those of many guesses.
        let differ = |items: &[Item]| {
            let texts: BTreeSet<_> = items.iter().map(|item| item.text.trim()).collect();
            texts.len()
        };
        let is_varied = differ(&evidence.items[..evidence.wrong]) >= VARIED;
        // The other ways to misread a question are suspects, too.
        let is_sure = evidence.wrong >= SURE && differ(&evidence.items) > 1;
        let is_left = |suspect: &&Suspect<'_>| {
            let answer = |k: usize| (suspect.answer)(&evidence.items[k].question);
            let most_missed = if evidence.is_rough() {
                evidence.wrong / MANY
            } else {
                0
            };
            let share_given = 1.0 - most_missed as f64 / evidence.wrong as f64;
            let score = evidence.score(share_given, answer);
            // Of many pairs, one or another explains half of all.
            let share = if suspect.is_two() { NEARLY_ALL } else { HALF };
            let in_all = all.score(share, |k| (suspect.answer)(&all.items[k].question));
            score.zip(in_all).is_some_and(|(score, in_all)| {
                let is_sharp = 2 * score.sharp >= score.explained;
                let is_told =
                    !suspect.is_guess || is_sharp && (is_varied || suspect.is_read && is_sure);
                let is_given = score.missed <= most_missed && in_all.contradicted == 0;
                is_given && !in_all.is_doubtful && is_told
            })
        };
        let mut left: Vec<_> = self.suspects.iter().filter(is_left).collect();
        // What a judge takes for the answers is not the mistake, where something else gives them to the last digits.
        let sharp = |suspect: &Suspect<'_>| {
            let answer = |k: usize| (suspect.answer)(&evidence.items[k].question);
            evidence.score(1.0, answer).map_or(0, |score| score.sharp)
        };
        if left.iter().any(|suspect| sharp(suspect) == evidence.wrong) {
            left.retain(|suspect| 2 * sharp(suspect) >= evidence.wrong);
        }
        // Who makes two mistakes does not make one of them alone.
        let all_left = left.clone();
        left.retain(|one| !all_left.iter().any(|two| one.is_half_of(two)));
        // One of the exercise's own says more than a guess, and one that explains as much as two is simpler.
        left.sort_by_key(|suspect| (suspect.is_guess, suspect.is_two()));
        let (first, others) = left.split_first()?;
        // What cannot be told from an own mistake is the same in other words; what cannot be told from a guess is another guess.
        let is_same = |other: &&Suspect<'_>| {
            let mut items = evidence.items.iter();
            !first.is_guess
                && items.all(|item| {
                    let [one, other] =
                        [first, other].map(|suspect| (suspect.answer)(&item.question));
                    same(one.as_deref(), other.as_deref())
                })
        };
        let explains_more = |other: &&Suspect<'_>| {
            other.is_two() && other.score.explained > first.score.explained + BY_CHANCE
        };
        // In whatever order they are made, two are these two.
        let is_named_so = |other: &Suspect<'_>| {
            other.is_two() && other.name == first.name && other.second() == first.second()
        };
        let is_the_one =
            (others.iter()).all(|one| is_named_so(one) || is_same(one) && !explains_more(one));
        let one = Diagnosis {
            name: first.name.clone(),
            hint: first.hint.clone(),
            // What two explain together, one of them does not.
            explained: if first.name == self.told.name && second(self.told).is_none() {
                self.told.explained.max(first.score.explained)
            } else {
                first.score.explained
            },
            further: evidence.wrong,
            beside: Beside::Apart,
            ..self.told.clone()
        };
        // What was told instead of it may be acquitted.
        let is_left = |name: &str| left.iter().any(|suspect| suspect.name == name);
        let is_acquitted = |also: &&Diagnosis| {
            let is_suspect = examiner.mistake_called(&also.name).is_some();
            also.beside == Beside::Instead && is_suspect && !is_left(&also.name)
        };
        let also = first.also.as_ref().filter(|also| !is_acquitted(also));
        is_the_one.then(|| self.convicted(&one, also))
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

/// Fair questions on which the first suspect shows, and which tell it from the others, and some on which it does not show: random ones,
/// and such as are near to those whose wrong answers it explains, or are these on another scale.
fn telling(evidence: &Evidence<'_>, suspects: &[Suspect<'_>], rng: &mut Pcg) -> Vec<Case> {
    let Some((first, others)) = suspects.split_first() else {
        return Vec::new();
    };
    let examiner = evidence.examiner;
    let right = |question: &[f64]| called(examiner.asked(), question);
    let wrong = evidence.items[..evidence.wrong].iter().enumerate();
    let explained = wrong.filter(|(k, item)| {
        let answer = (first.answer)(&item.question);
        answer.is_some_and(|answer| evidence.explains(*k, &answer))
    });
    let explained: Vec<_> = explained.map(|(_, item)| &item.question).collect();
    let least = if evidence.is_rough() {
        ENOUGH_ROUGH
    } else {
        SHOWN / 2
    };
    // On a small scale there may be a million points, which tell no more than a hundred.
    let longest = evidence.items.iter().map(|item| item.got.len()).max();
    let answered = |question: &[f64]| {
        let answer = (first.answer)(question);
        answer.filter(|answer| Some(answer.len()) <= longest)
    };
    let (mut shown, mut hidden) = (0, 0);
    let mut told_from = vec![0; others.len()];
    let mut cases: Vec<Case> = Vec::new();
    for i in 0..(DRAWN / examiner.limits().effort).max(FEWEST) {
        let are_told = told_from.iter().all(|count| *count >= ENOUGH) || shown == SHOWN;
        let are_hidden = hidden == HIDDEN || i >= ALL_SHOW;
        if shown >= least && are_told && are_hidden {
            break;
        }
        // On another scale, one question is hardly more than itself: guesses, of which there are many, need other questions.
        let is_scaled = i % 4 == 3 && !first.is_guess && !explained.is_empty();
        let question = match explained.get(i / 4 % explained.len().max(1)) {
            Some(wrong) if is_scaled => {
                let whole = scaled(examiner, wrong, 1.0, rng);
                let answer = answered(&whole).filter(|_| examiner.is_sound(&whole));
                if answer.is_some_and(|answer| !examiner.is_right(&whole, &answer)) {
                    whole
                } else {
                    scaled(examiner, wrong, HALF, rng)
                }
            }
            Some(wrong) if i % 2 == 1 => near(wrong, rng),
            _ => examiner.random(rng),
        };
        if !examiner.is_sound(&question) {
            continue;
        }
        let Some(answer) = answered(&question) else {
            continue;
        };
        let shows = !examiner.is_right(&question, &answer);
        if shows && shown == SHOWN || !shows && hidden == HIDDEN {
            continue;
        }
        let differs =
            |other: &Suspect<'_>| !same((other.answer)(&question).as_deref(), Some(&answer));
        let differ: Vec<_> = others.iter().map(|other| shows && differs(other)).collect();
        let mut each = told_from.iter().zip(&differ);
        let tells = each.any(|(count, differs)| *differs && *count < ENOUGH);
        let is_wanted = !shows || tells || shown < least;
        let is_fair = |rng: &mut Pcg| {
            // What rounding decides, it decides in a scaled question as in the one that was asked; not always as its judge does.
            if is_scaled {
                let right = right(&question);
                return right.is_some_and(|right| examiner.is_right(&question, &right));
            }
            // Of two mistakes it decides more than of one.
            let mut is_settled = |answer| is_settled(examiner, &question, answer, rng);
            is_settled(&right)
                && (!first.is_two() || is_settled(&*first.answer))
                && is_stable(examiner, &question, rng)
        };
        if !is_wanted || !is_fair(rng) {
            continue;
        }
        let Ok(case) = examiner.case("a further question", &question) else {
            continue;
        };
        if is_scaled && cases.iter().any(|other| other.question == case.question) {
            continue;
        }
        if shows {
            shown += 1;
            for (count, differs) in told_from.iter_mut().zip(differ) {
                *count += usize::from(differs);
            }
        } else {
            hidden += 1;
        }
        cases.push(case);
    }
    cases
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

/// A question whose numbers are a fifth larger or smaller at most, but for whole ones.
fn near(question: &[f64], rng: &mut Pcg) -> Vec<f64> {
    let moved = question.iter().map(|v| {
        if v.is_finite() && v.fract() != 0.0 {
            f64::from((v * rng.random_range(0.8..1.2)) as f32)
        } else {
            *v
        }
    });
    moved.collect()
}

/// A question whose lengths, and all other numbers that are neither whole nor of a direction, are a power of two times as large, those of each
/// field with this probability: no digit changes, and what is equal stays equal, such as a discriminant and 0. What a ratio is compared with
/// must not grow with its two numbers, and so some fields stay as they are where all together show nothing.
fn scaled(examiner: &dyn Examiner, question: &[f64], probability: f64, rng: &mut Pcg) -> Vec<f64> {
    /// The largest power, and the smallest.
    const POWER: i32 = 5;
    let factor = f64::from(rng.random_range(-POWER..=POWER)).exp2();
    let is_scaled = |kind: &Kind| !matches!(kind, Kind::Whole | Kind::Direction);
    let leaves = leaves(examiner, question, is_scaled);
    let mut fields: BTreeSet<usize> = leaves.iter().map(|leaf| leaf.part).collect();
    fields.retain(|_| rng.random_bool(probability));
    let mut scaled = question.to_vec();
    for leaf in leaves.iter().filter(|leaf| fields.contains(&leaf.part)) {
        scaled[leaf.range()].iter_mut().for_each(|v| *v *= factor);
    }
    scaled
}
