//! Who may have made the wrong answers: what is told of them, and what explains them nearly as well.

use crate::attempt::attempt;
use crate::diagnose::evidence::{Evidence, Score};
use crate::diagnose::misread::{Misreading, misreadings};
use crate::diagnose::pairs::{SLOW, TOGETHER, of_two};
use crate::diagnose::search::called;
use crate::diagnose::slips::{Slipped, slipped};
use crate::diagnose::{Beside, Diagnosis};
use crate::each::each;
use crate::examine::Examiner;
use raybook_workbook::exercise::Asked;
use std::rc::Rc;

/// A suspect gives this many wrong answers for each that is not as it says.
const NEARLY: usize = 5;

/// Wrong answers that a second mistake explains by chance.
pub const BY_CHANCE: usize = 1;

/// Other pairs that are suspects, those that give most.
const MOST_PAIRS: usize = 4;

/// The share of the wrong answers that is asked of a suspect first.
pub const HALF: f64 = 0.5;

/// What is answered to a question by one who makes a mistake.
type Answer<'a> = Box<dyn Fn(&[f64]) -> Option<Vec<f64>> + 'a>;

/// A mistake, or two at once, that may have made the wrong answers.
pub struct Suspect<'a> {
    pub name: String,
    pub hint: String,
    /// A second mistake that is made with it, or was told instead of it.
    pub also: Option<Diagnosis>,
    pub answer: Answer<'a>,
    /// Whether it is none of the exercise's own: of guesses there are many.
    pub is_guess: bool,
    /// Whether it is a question that was misread.
    pub is_read: bool,
    /// How it explains the answers that are known.
    pub score: Score,
}

impl Suspect<'_> {
    /// Whether it is two mistakes at once.
    pub fn is_two(&self) -> bool {
        self.second().is_some()
    }

    /// The name of the second of two mistakes.
    pub fn second(&self) -> Option<&str> {
        let also = self.also.as_ref();
        let also = also.filter(|also| also.beside == Beside::Together);
        also.map(|also| also.name.as_str())
    }

    /// Whether it is one of two of the exercise's own mistakes that explain more than chance does.
    pub fn is_half_of(&self, two: &Self) -> bool {
        let is_one = two.name == self.name || two.second() == Some(&self.name);
        let explain_more = two.score.explained > self.score.explained + BY_CHANCE;
        !self.is_two() && two.is_two() && !two.is_guess && is_one && explain_more
    }
}

/// What may have made the answers: first what is told, then the own mistakes that give nearly all of them, and beside a guess the other
/// ways to misread the question that do.
pub fn suspects<'a>(evidence: &Evidence<'a>, told: &Diagnosis) -> Vec<Suspect<'a>> {
    let examiner = evidence.examiner;
    // Short answers are compared soonest.
    let few = evidence.few(HALF, |k| evidence.items[k].got.len());
    let near = |answer: &dyn Fn(usize) -> Option<Vec<f64>>| {
        let score = evidence.score_after(&few, HALF, answer)?;
        let is_near = NEARLY * (score.missed + score.contradicted) <= score.explained;
        is_near.then_some(score)
    };
    let suspect =
        |(name, hint): (&str, &str), is_guess, also: Option<Diagnosis>, answer: Answer<'a>| {
            let score = near(&|k| answer(&evidence.items[k].question))?;
            let is_two = also
                .as_ref()
                .is_some_and(|also| also.beside == Beside::Together);
            Some(Suspect {
                name: name.to_owned(),
                hint: hint.to_owned(),
                is_read: is_guess && !is_two && reading_called(examiner, name).is_some(),
                also,
                answer,
                is_guess,
                score,
            })
        };
    let words = (&*told.name, &*told.hint);
    let number = examiner.mistake_called(&told.name);
    let second = |beside| told.also.iter().find(move |also| also.beside == beside);
    let apart = second(Beside::Apart).filter(|also| examiner.mistake_called(&also.name).is_some());
    let mut all: Vec<Suspect<'a>> = Vec::new();
    if let Some(second) = second(Beside::Together).or(apart) {
        let also = Diagnosis {
            beside: Beside::Together,
            ..second.clone()
        };
        let two = [number, examiner.mistake_called(&second.name)];
        let ways = match two {
            [Some(one), Some(other)] => ways(evidence, one, other),
            _ => guessed_ways(evidence, [told, second]),
        };
        let is_guess = two.contains(&None);
        let ways = ways.into_iter();
        let ways = ways.filter_map(|way| suspect(words, is_guess, Some(also.clone()), way));
        all.extend(ways);
        // In either order two may give all answers that are known, and not those to further questions.
        all.sort_by_key(|way| way.score.missed + way.score.contradicted);
        if let [Some(one), Some(other)] = two
            && examiner.limits().effort < SLOW
        {
            all.extend(other_pairs(evidence, [one, other], &also, &near));
        }
    } else if let Some(number) = number {
        let also = second(Beside::Instead).cloned();
        all.extend(suspect(words, false, also, own(examiner, number)));
    } else {
        let also = second(Beside::Instead);
        let guess = |answer| suspect(words, true, also.cloned(), answer);
        all.extend(guessed(evidence, told).into_iter().find_map(guess));
    }
    if all.first().is_some_and(|one| one.is_guess && !one.is_two()) {
        let asked = examiner.asked();
        for reading in misreadings(asked.question, examiner.limits()) {
            let (name, hint) = (reading.name.clone(), reading.hint.clone());
            let is_told = |one: &Diagnosis| one.name == name;
            if !is_told(told) && !told.also.iter().any(is_told) {
                all.extend(suspect((&name, &hint), true, None, read(asked, reading)));
            }
        }
    }
    let is_there = all.iter().any(|one| !one.is_two());
    let others = examiner.mistakes().into_iter().enumerate();
    let others = others.filter(|(_, (name, _))| !is_there || *name != told.name);
    let others: Vec<_> = others.collect();
    let scores = each(&others, |(i, _)| near(&|k| evidence.mistaken(*i, k)));
    let others = others.into_iter().zip(scores);
    all.extend(others.filter_map(|((i, (name, hint)), score)| {
        Some(Suspect {
            name: name.to_owned(),
            hint: hint.to_owned(),
            also: None,
            answer: own(examiner, i),
            is_guess: false,
            is_read: false,
            score: score?,
        })
    }));
    all
}

/// How what is answered explains the answers that are known, if it gives nearly all of them.
type Near<'a> = dyn Fn(&dyn Fn(usize) -> Option<Vec<f64>>) -> Option<Score> + Sync + 'a;

/// Other two of the exercise's own mistakes that give nearly all answers, of which one is told, with this `second` mistake.
fn other_pairs<'a>(
    evidence: &Evidence<'a>,
    [one, other]: [usize; 2],
    second: &Diagnosis,
    near: &Near<'_>,
) -> Vec<Suspect<'a>> {
    let mistakes = evidence.examiner.mistakes();
    let others = (0..mistakes.len()).filter(|i| ![one, other].contains(i));
    let pairs: Vec<_> = others.flat_map(|i| [[one, i], [other, i]]).collect();
    let best = |&[one, other]: &[usize; 2]| {
        // Beside each other, two may give by chance what one upon another does.
        let ways = upon_ways(evidence.examiner, one, other)
            .into_iter()
            .enumerate();
        let scores = ways.filter_map(|(number, way)| {
            let score = near(&|k| way(&evidence.items[k].question))?;
            Some((number, score))
        });
        scores.min_by_key(|(_, score)| score.missed + score.contradicted)
    };
    let best = pairs.iter().zip(each(&pairs, best));
    let best = best.filter_map(|(pair, best)| Some((pair, best?)));
    let mut best: Vec<_> = best.collect();
    best.sort_by_key(|(_, (_, score))| score.missed + score.contradicted);
    best.truncate(MOST_PAIRS);
    let pairs = best.into_iter().map(|(&[one, other], (number, score))| {
        let (name, hint) = mistakes[one];
        let also = Diagnosis {
            name: mistakes[other].0.to_owned(),
            hint: mistakes[other].1.to_owned(),
            ..second.clone()
        };
        Suspect {
            name: name.to_owned(),
            hint: hint.to_owned(),
            also: Some(also),
            answer: upon_ways(evidence.examiner, one, other).swap_remove(number),
            is_guess: false,
            is_read: false,
            score,
        }
    });
    pairs.collect()
}

/// What one answers who makes two of the exercise's own mistakes: one upon the other, or each where the other does not meddle.
fn ways<'a>(evidence: &Evidence<'a>, one: usize, other: usize) -> Vec<Answer<'a>> {
    let examiner = evidence.examiner;
    let mut ways = upon_ways(examiner, one, other);
    ways.extend(beside_ways(
        examiner,
        [own(examiner, one), own(examiner, other)],
    ));
    ways
}

/// What one answers who makes one of the exercise's own mistakes upon the other.
fn upon_ways(examiner: &dyn Examiner, one: usize, other: usize) -> Vec<Answer<'_>> {
    let upon = |first, second| -> Answer<'_> {
        Box::new(move |question| {
            let answer = attempt(|| examiner.mistakes_answer(first, second, question))?;
            answer.map(|(answer, _)| answer)
        })
    };
    vec![upon(one, other), upon(other, one)]
}

/// What one answers who makes one of the exercise's own mistakes.
fn own(examiner: &dyn Examiner, mistake: usize) -> Answer<'_> {
    Box::new(move |question| attempt(|| examiner.mistake_answers(mistake, question))?)
}

/// What one answers who makes two mistakes, each where the other does not meddle.
fn beside_ways<'a>(examiner: &'a dyn Examiner, two: [Answer<'a>; 2]) -> Vec<Answer<'a>> {
    let two = Rc::new(two);
    let way = |together| -> Answer<'a> {
        let two = Rc::clone(&two);
        Box::new(move |question| {
            let right = called(examiner.asked(), question)?;
            let [one, other] = &*two;
            of_two(&right, &one(question)?, &other(question)?, together)
        })
    };
    TOGETHER.map(way).into()
}

/// What one answers who makes two mistakes that are not both the exercise's own.
fn guessed_ways<'a>(evidence: &Evidence<'a>, two: [&Diagnosis; 2]) -> Vec<Answer<'a>> {
    let mut ways = misread_ways(evidence.examiner, two);
    ways.extend(slipped_way(evidence, two));
    ways.extend(slipped_and_own_ways(evidence, two));
    ways
}

/// What one answers who goes wrong at two steps of one way, or at one and misreads the question.
fn slipped_way<'a>(evidence: &Evidence<'a>, two: [&Diagnosis; 2]) -> Option<Answer<'a>> {
    let examiner = evidence.examiner;
    let read = move |told: &Diagnosis, slip: Slipped| -> Option<Answer<'a>> {
        let reading = reading_of(examiner, told)?;
        let read = move |question: &[f64]| reading.read_or_not(examiner.asked().question, question);
        Some(Box::new(move |question| slip.answer(&read(question))))
    };
    let [one, other] = two;
    match two.map(|told| slip_of(evidence, told)) {
        [Some(first), Some(then)] if then.goes_with(&first) => {
            let way: Answer<'a> = Box::new(move |question| then.answer_with(&first, question));
            Some(way)
        }
        [Some(slip), None] => read(other, slip),
        [None, Some(slip)] => read(one, slip),
        _ => None,
    }
}

/// What one answers who goes wrong at a step and makes one of the exercise's own mistakes.
fn slipped_and_own_ways<'a>(evidence: &Evidence<'a>, two: [&Diagnosis; 2]) -> Vec<Answer<'a>> {
    let examiner = evidence.examiner;
    let (one, other) = match two.map(|told| examiner.mistake_called(&told.name)) {
        [Some(number), None] => (number, two[1]),
        [None, Some(number)] => (number, two[0]),
        _ => return Vec::new(),
    };
    let Some(slip) = slip_of(evidence, other) else {
        return Vec::new();
    };
    let slipped = Box::new(move |question: &[f64]| slip.answer(question));
    beside_ways(examiner, [own(examiner, one), slipped])
}

/// What one answers who misreads the question and makes one of the exercise's own mistakes with it, or misreads it twice.
fn misread_ways<'a>(examiner: &'a dyn Examiner, two: [&Diagnosis; 2]) -> Vec<Answer<'a>> {
    let asked = examiner.asked();
    let way = |[first, then]: [&Diagnosis; 2]| -> Option<Answer<'a>> {
        let reading = reading_of(examiner, first)?;
        let read = move |question: &[f64]| reading.read_or_not(asked.question, question);
        if let Some(number) = examiner.mistake_called(&then.name) {
            return Some(Box::new(move |question| {
                attempt(|| examiner.mistake_answers(number, &read(question)))?
            }));
        }
        let again = self::read(asked, reading_of(examiner, then)?);
        Some(Box::new(move |question| again(&read(question))))
    };
    let [one, other] = two;
    let ways = [[one, other], [other, one]].into_iter();
    ways.filter_map(way).collect()
}

/// What one answers who misreads the question, or goes wrong at a step, as is told: several ways may have a step of that name.
fn guessed<'a>(evidence: &Evidence<'a>, told: &Diagnosis) -> Vec<Answer<'a>> {
    if let Some(reading) = reading_of(evidence.examiner, told) {
        return vec![read(evidence.examiner.asked(), reading)];
    }
    let answer = |slip: Slipped| -> Answer<'a> { Box::new(move |question| slip.answer(question)) };
    slips_of(evidence, told).map(answer).collect()
}

/// The steps that go wrong as is told, each of another way.
fn slips_of(evidence: &Evidence<'_>, told: &Diagnosis) -> impl Iterator<Item = Slipped> {
    let slips = slipped(evidence).into_iter();
    slips.filter(|slip| slip.name == told.name && !slip.is_doubtful())
}

/// The first of them.
fn slip_of(evidence: &Evidence<'_>, told: &Diagnosis) -> Option<Slipped> {
    slips_of(evidence, told).next()
}

/// The way to misread the question that is told.
fn reading_of(examiner: &dyn Examiner, told: &Diagnosis) -> Option<Misreading> {
    reading_called(examiner, &told.name)
}

/// The way to misread the question that has this name.
fn reading_called(examiner: &dyn Examiner, name: &str) -> Option<Misreading> {
    let readings = misreadings(examiner.asked().question, examiner.limits());
    readings.into_iter().find(|one| one.name == name)
}

/// The right answers to questions that are misread.
fn read<'a>(asked: &'static Asked, reading: Misreading) -> Answer<'a> {
    Box::new(move |question| called(asked, &reading.read_or_not(asked.question, question)))
}
