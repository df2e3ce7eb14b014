//! The trial of a mistake that the answers leave in doubt: further questions on which it shows, and which tell it from others.
//!
//! Two wrong answers of yes or no are those of many mistakes. Who suspects one of them can ask where it shows: if each further answer is as
//! it says, and not as any other suspect says, it is the one.

use super::evidence::{Evidence, Score};
use super::misread::misreadings;
use super::pairs::{TOGETHER, of_two};
use super::search::called;
use super::slips::slipped;
use super::{Beside, Diagnosis, diagnose};
use crate::attempt::attempt;
use crate::examine::{Case, Examiner, visible_rng};
use crate::stable::is_stable;
use rand::RngExt;
use raybook::math::pcg::Pcg;

/// Further questions on which the first suspect shows, at most.
const SHOWN: usize = 32;

/// Questions on which it shows that tell enough, and those by which it is told from each other suspect.
const ENOUGH: usize = 8;

/// Questions on which it does not show.
const HIDDEN: usize = 8;

/// Random questions that are looked through, divided by the effort of an answer, and the fewest.
const DRAWN: usize = 2000;
const FEWEST: usize = 40;

/// A suspect gives this many wrong answers for each that is not as it says.
const NEARLY: usize = 5;

/// Wrong answers that a second mistake explains by chance.
const BY_CHANCE: usize = 1;

/// Rounds of random cases that are asked where answers are compared by their traits.
const ROUNDS: usize = 3;

/// What is answered to a question by one who makes a mistake.
type Answer<'a> = Box<dyn Fn(&[f64]) -> Option<Vec<f64>> + 'a>;

/// A mistake, or two at once, that may have made the wrong answers.
struct Suspect<'a> {
    name: String,
    hint: String,
    /// A second mistake that is made with it.
    then: Option<(String, String)>,
    answer: Answer<'a>,
    score: Score,
}

/// Further questions, and what is suspected.
pub struct Trial<'a> {
    examiner: &'a dyn Examiner,
    told: &'a Diagnosis,
    /// What is told is the first of them. None where answers are compared by their traits.
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
        if told.certain || told.part.is_some() {
            return None;
        }
        let evidence = Evidence::new(examiner, cases, answers);
        let seed = format!("{}, once more", cases.last()?.question);
        let suspects = suspects(&evidence, told);
        let is_told = |first: &Suspect<'_>| evidence.is_judged() || first.name == told.name;
        if suspects.first().is_some_and(is_told) {
            let cases = telling(&evidence, &suspects, &seed);
            return Some(Self {
                examiner,
                told,
                suspects,
                cases,
            });
        }
        if evidence.is_judged() {
            return None;
        }
        number_of(examiner, &told.name)?;
        let rng = &mut visible_rng(&seed);
        let random = (0..ROUNDS).map(|_| examiner.try_random_cases(rng));
        let random = random.collect::<Result<Vec<_>, _>>().ok()?;
        Some(Self {
            examiner,
            told,
            suspects: Vec::new(),
            cases: random.into_iter().flat_map(|one| one.cases).collect(),
        })
    }

    /// What is told after it: for certain, if all is as one suspect says; else none. `cases` and `answers` are those of before and the further ones.
    pub fn verdict(&self, cases: &[Case], answers: &[(Option<String>, bool)]) -> Option<Diagnosis> {
        if self.suspects.is_empty() {
            let found = diagnose(self.examiner, cases, answers)?;
            let is_sure = found.certain && found.name == self.told.name;
            return is_sure.then(|| self.told_of(&self.told.name, &self.told.hint, None));
        }
        let further = cases.len() - self.cases.len();
        let evidence = Evidence::new(self.examiner, &self.cases, &answers[further..]);
        let is_left = |suspect: &&Suspect<'_>| {
            let answer = |k: usize| (suspect.answer)(&evidence.items[k].question);
            let score = evidence.score(1.0, answer);
            score.is_some_and(|score| {
                score.missed + score.contradicted == 0
                    && score.explained >= ENOUGH
                    && !score.is_doubtful
            })
        };
        if evidence.wrong < ENOUGH {
            return None;
        }
        let mut left: Vec<_> = self.suspects.iter().filter(is_left).collect();
        // One mistake that explains as much as two is simpler.
        left.sort_by_key(|suspect| suspect.then.is_some());
        let (first, others) = left.split_first()?;
        // What cannot be told from it is the same mistake in other words.
        let is_same = |other: &&Suspect<'_>| {
            let mut items = 0..evidence.items.len();
            items.all(|k| {
                let question = &evidence.items[k].question;
                let [one, other] = [first, other].map(|suspect| (suspect.answer)(question));
                one == other
            })
        };
        let explains_more =
            |other: &&Suspect<'_>| other.score.explained > first.score.explained + BY_CHANCE;
        let is_alone = others.iter().all(|one| is_same(one) && !explains_more(one));
        is_alone.then(|| {
            self.told_of(&first.name, &first.hint, first.then.as_ref())
                .of(&first.score)
        })
    }

    /// What is told of a mistake for certain.
    fn told_of(&self, name: &str, hint: &str, then: Option<&(String, String)>) -> Diagnosis {
        let one = |name: &str, hint: &str, beside| Diagnosis {
            name: name.to_owned(),
            hint: hint.to_owned(),
            certain: true,
            beside,
            also: Vec::new(),
            ..self.told.clone()
        };
        let shown = self
            .told
            .also
            .iter()
            .filter(|also| also.beside == Beside::Shown);
        let then = then.map(|(name, hint)| one(name, hint, Beside::Together));
        Diagnosis {
            also: then.into_iter().chain(shown.cloned()).collect(),
            ..one(name, hint, Beside::Apart)
        }
    }
}

impl Diagnosis {
    /// The same of as many answers as this score explains.
    fn of(self, score: &Score) -> Self {
        Self {
            explained: score.explained,
            ..self
        }
    }
}

/// The number of the own mistake that is called so.
fn number_of(examiner: &dyn Examiner, name: &str) -> Option<usize> {
    let mut all = examiner.mistakes().into_iter();
    all.position(|(own, _)| own == name)
}

/// What may have made the answers: first what is told, then the own mistakes that give nearly all of them.
fn suspects<'a>(evidence: &Evidence<'a>, told: &Diagnosis) -> Vec<Suspect<'a>> {
    let examiner = evidence.examiner;
    let suspect = |name: &str, hint: &str, then: Option<&Diagnosis>, answer: Answer<'a>| {
        let predict = |k: usize| answer(&evidence.items[k].question);
        let score = evidence.score(0.5, predict)?;
        let is_near = NEARLY * (score.missed + score.contradicted) <= score.explained;
        is_near.then(|| Suspect {
            name: name.to_owned(),
            hint: hint.to_owned(),
            then: then.map(|then| (then.name.clone(), then.hint.clone())),
            answer,
            score,
        })
    };
    let own = |i: usize| -> Answer<'a> {
        Box::new(move |question| attempt(|| examiner.mistake_answers(i, question))?)
    };
    let second = |beside| told.also.iter().find(move |also| also.beside == beside);
    let apart = second(Beside::Apart).filter(|also| number_of(examiner, &also.name).is_some());
    let second = second(Beside::Together).or(apart);
    let mut all: Vec<Suspect<'a>> = Vec::new();
    match (number_of(examiner, &told.name), second) {
        // Of lists that chance makes, two mistakes of which one undoes half of the other give the same as a third.
        (Some(first), Some(second)) if evidence.is_judged() => {
            if let Some(other) = number_of(examiner, &second.name) {
                let ways = ways(examiner, first, other).into_iter();
                let ways =
                    ways.filter_map(|way| suspect(&told.name, &told.hint, Some(second), way));
                all.extend(ways.min_by_key(|way| way.score.missed + way.score.contradicted));
            }
        }
        (Some(first), None) => all.extend(suspect(&told.name, &told.hint, None, own(first))),
        (None, None) => all.extend(
            other(evidence, told).and_then(|answer| suspect(&told.name, &told.hint, None, answer)),
        ),
        (_, Some(_)) => {}
    }
    let mistakes = examiner.mistakes().into_iter().enumerate();
    let others = mistakes.filter(|(_, (name, _))| second.is_some() || *name != told.name);
    all.extend(others.filter_map(|(i, (name, hint))| suspect(name, hint, None, own(i))));
    all
}

/// What one answers who makes two of the exercise's own mistakes: one upon the other, or each where the other does not meddle.
fn ways<'a>(examiner: &'a dyn Examiner, first: usize, second: usize) -> Vec<Answer<'a>> {
    let upon = |first, second| -> Answer<'a> {
        Box::new(move |question| {
            let answer = attempt(|| examiner.mistakes_answer(first, second, question))?;
            answer.map(|(answer, _)| answer)
        })
    };
    let beside = TOGETHER.map(|together| -> Answer<'a> {
        Box::new(move |question| {
            let right = called(examiner.asked(), question)?;
            let alone = |i| attempt(|| examiner.mistake_answers(i, question))?;
            of_two(&right, &alone(first)?, &alone(second)?, together)
        })
    });
    let mut ways = vec![upon(first, second), upon(second, first)];
    ways.extend(beside);
    ways
}

/// What one answers who misreads the question, or goes wrong at a step, as is told.
fn other<'a>(evidence: &Evidence<'a>, told: &Diagnosis) -> Option<Answer<'a>> {
    let asked = evidence.examiner.asked();
    let mut readings = misreadings(asked.question, evidence.examiner.limits()).into_iter();
    if let Some(reading) = readings.find(|reading| reading.name == told.name) {
        return Some(Box::new(move |question| {
            called(asked, &reading.read_or_not(asked.question, question))
        }));
    }
    let mut slips = slipped(evidence).into_iter();
    let slip = slips.find(|slip| slip.name == told.name && !slip.is_doubtful())?;
    Some(Box::new(move |question| slip.answer(question)))
}

/// Fair questions on which the first suspect shows, and which tell it from the others, and some on which it does not show: random ones,
/// and such as are near to those of the wrong answers.
fn telling(evidence: &Evidence<'_>, suspects: &[Suspect<'_>], seed: &str) -> Vec<Case> {
    let Some((first, others)) = suspects.split_first() else {
        return Vec::new();
    };
    let examiner = evidence.examiner;
    let rng = &mut visible_rng(seed);
    let (mut shown, mut hidden) = (0, 0);
    let mut told_from = vec![0; others.len()];
    let mut cases = Vec::new();
    for i in 0..(DRAWN / examiner.limits().effort).max(FEWEST) {
        let question = if i % 2 == 0 {
            examiner.random(rng)
        } else {
            near(&evidence.items[i / 2 % evidence.wrong].question, rng)
        };
        if i % 2 == 1 && !examiner.is_sound(&question) {
            continue;
        }
        let Some(answer) = (first.answer)(&question) else {
            continue;
        };
        let shows = !examiner.is_right(&question, &answer);
        let differs = |other: &Suspect<'_>| (other.answer)(&question).as_ref() != Some(&answer);
        let differ: Vec<_> = others.iter().map(differs).collect();
        let mut each = told_from.iter().zip(&differ);
        let tells = each.any(|(count, differs)| *differs && *count < ENOUGH);
        let most = match (shows, tells) {
            (true, true) => shown < SHOWN,
            (true, false) => shown < SHOWN / 2,
            (false, _) => hidden < HIDDEN,
        };
        if !most || !is_stable(examiner, &question, rng) {
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
        cases.extend(examiner.case("a further question", &question));
        let is_told = told_from.iter().all(|count| *count >= ENOUGH) || shown == SHOWN;
        if shown >= SHOWN / 2 && hidden == HIDDEN && is_told {
            break;
        }
    }
    cases
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
