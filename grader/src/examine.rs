//! Making cases, judging answers and recognising mistakes, with everything as lines.

use crate::diagnose::misread::Limits;
use crate::finite::finite;
use crate::golden::{self, GoldenError, Named};
use crate::triple::PictureSize;
use crate::{Flaw, Graded, Mistake, Picture, Verdict, stable};
use raybook::image::rgb::Rgb;
use raybook::math::pcg::{self, Pcg};
use raybook_workbook::exercise::Asked;
use raybook_workbook::row::{self, RowError, from_numbers, to_numbers};
use std::borrow::Cow;
use std::marker::PhantomData;

/// How many random cases an exercise has beside its named ones.
pub const RANDOM_CASES: usize = 34;

/// One question with its right answers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Case {
    /// Its number among the exercise's cases, from 1.
    pub number: usize,
    /// What is special about it, or "random 7".
    pub name: String,
    /// The question, without the exercise's name.
    pub question: String,
    /// The golden answer, and others that are as right.
    pub answers: Vec<String>,
}

/// Cases, and how many random questions were thrown away because a last digit decides them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cases {
    /// The cases, named ones first.
    pub cases: Vec<Case>,
    /// Questions thrown away.
    pub thrown_away: usize,
}

impl Cases {
    /// The fraction of random questions that was thrown away.
    pub fn thrown_away_fraction(&self) -> f32 {
        self.thrown_away as f32 / (self.thrown_away + RANDOM_CASES) as f32
    }
}

/// Why there are no cases.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CasesError {
    /// A named case cannot be read.
    #[error(transparent)]
    Golden(#[from] GoldenError),
    /// The reference has no answer to a question.
    #[error("{0}")]
    Reference(String),
}

/// A graded exercise whose types are forgotten: questions and answers are rows of numbers. What can be said of lines is a method
/// of `dyn Examiner`.
pub trait Examiner: Sync {
    /// The exercise.
    fn asked(&self) -> &'static Asked;

    /// The text of its golden file.
    fn golden(&self) -> &str;

    /// The same exercise with the text of another golden file.
    fn with_golden(&self, text: String) -> Box<dyn Examiner>;

    /// An ordinary question.
    fn random(&self, rng: &mut Pcg) -> Vec<f64>;

    /// The right answer to a question.
    ///
    /// # Errors
    /// Why there is none. What is compiled in always answers.
    fn reference(&self, question: &[f64]) -> Result<Vec<f64>, String> {
        Ok((self.asked().call)(question))
    }

    /// Compares an answer with the golden one.
    ///
    /// # Errors
    /// Why it is wrong.
    fn compare(&self, question: &[f64], golden: &[f64], got: &[f64]) -> Verdict;

    /// What kept the judge from a verdict on this thread, and is no fault of an answer; told once.
    fn trouble(&self) -> Option<String> {
        None
    }

    /// See [`Graded::together`]; each question with its answer.
    ///
    /// # Errors
    /// What is wrong with them.
    fn compare_together(&self, answers: &[(Vec<f64>, Vec<f64>)]) -> Verdict;

    /// The name and the hint of mistake number i.
    fn mistake(&self, i: usize) -> Option<(&'static str, &'static str)>;

    /// What mistake number i answers.
    fn mistake_answers(&self, i: usize, question: &[f64]) -> Option<Vec<f64>>;

    /// See [`Graded::canonical`].
    fn canonical(&self, question: &[f64], answer: &[f64]) -> Vec<f64>;

    /// See [`Graded::FLAWS`].
    fn flaws(&self) -> &'static [Flaw];

    /// See [`Graded::ULPS`].
    fn ulps(&self) -> i32;

    /// See [`Graded::ALIKE`].
    fn alike(&self) -> f32;

    /// See [`Graded::traits`].
    fn traits(&self, question: &[f64], answer: &[f64]) -> Vec<f64>;

    /// See [`Graded::POSITIVE`], [`Graded::FIXED`] and [`Graded::SLOW`].
    fn limits(&self) -> Limits;

    /// See [`Graded::is_sound`].
    fn is_sound(&self, question: &[f64]) -> bool;

    /// Picture number i that answers make.
    fn picture(&self, i: usize) -> Option<PictureSize>;

    /// The question of a pixel of picture number i.
    fn pixel(&self, i: usize, x: u32, y: u32) -> Option<Vec<f64>>;

    /// The colour of a pixel's answer in picture number i.
    fn colour(&self, i: usize, question: &[f64], answer: &[f64]) -> Option<Rgb>;
}

/// The examiner of an exercise, with the text of its golden file.
pub(crate) struct Examination<E> {
    golden: Cow<'static, str>,
    exercise: PhantomData<E>,
}

impl<E> Examination<E> {
    /// The examiner with the golden file that the command carries with it.
    pub(crate) const fn new(golden: &'static str) -> Self {
        Self {
            golden: Cow::Borrowed(golden),
            exercise: PhantomData,
        }
    }
}

impl<E: Graded> Examiner for Examination<E> {
    fn asked(&self) -> &'static Asked {
        const { &Asked::of::<E>() }
    }

    fn golden(&self) -> &str {
        &self.golden
    }

    fn with_golden(&self, text: String) -> Box<dyn Examiner> {
        Box::new(Self {
            golden: Cow::Owned(text),
            exercise: PhantomData,
        })
    }

    fn random(&self, rng: &mut Pcg) -> Vec<f64> {
        to_numbers(&E::random(rng))
    }

    fn compare(&self, question: &[f64], golden: &[f64], got: &[f64]) -> Verdict {
        E::judge(
            &from_numbers(question),
            &from_numbers(golden),
            &from_numbers(got),
        )
    }

    fn compare_together(&self, answers: &[(Vec<f64>, Vec<f64>)]) -> Verdict {
        let rows = answers.iter();
        let answers: Vec<_> = rows
            .map(|(question, got)| (from_numbers(question), from_numbers(got)))
            .collect();
        E::together(&answers)
    }

    fn mistake(&self, i: usize) -> Option<(&'static str, &'static str)> {
        let Mistake { name, hint, .. } = E::MISTAKES.get(i)?;
        Some((name, hint))
    }

    fn mistake_answers(&self, i: usize, question: &[f64]) -> Option<Vec<f64>> {
        let answer = E::MISTAKES.get(i)?.answer;
        Some(to_numbers(&answer(&from_numbers(question))))
    }

    fn canonical(&self, question: &[f64], answer: &[f64]) -> Vec<f64> {
        to_numbers(&E::canonical(&from_numbers(question), from_numbers(answer)))
    }

    fn flaws(&self) -> &'static [Flaw] {
        E::FLAWS
    }

    fn ulps(&self) -> i32 {
        E::ULPS
    }

    fn alike(&self) -> f32 {
        E::ALIKE
    }

    fn traits(&self, question: &[f64], answer: &[f64]) -> Vec<f64> {
        E::traits(&from_numbers(question), &from_numbers(answer))
    }

    fn limits(&self) -> Limits {
        Limits {
            positive: E::POSITIVE,
            fixed: E::FIXED,
            slow: E::SLOW,
        }
    }

    fn is_sound(&self, question: &[f64]) -> bool {
        E::is_sound(&from_numbers(question))
    }

    fn picture(&self, i: usize) -> Option<PictureSize> {
        let picture: &Picture<E> = E::PICTURES.get(i)?;
        Some(PictureSize {
            name: picture.name,
            width: picture.width,
            height: picture.height,
            alt: picture.alt,
        })
    }

    fn pixel(&self, i: usize, x: u32, y: u32) -> Option<Vec<f64>> {
        Some(to_numbers(&(E::PICTURES.get(i)?.question)(x, y)))
    }

    fn colour(&self, i: usize, question: &[f64], answer: &[f64]) -> Option<Rgb> {
        let colour = E::PICTURES.get(i)?.colour;
        Some(colour(&from_numbers(question), &from_numbers(answer)))
    }
}

/// The random numbers of an exercise's visible cases: the same for everyone, for ever.
pub fn visible_rng(exercise: &str) -> Pcg {
    let name = exercise.bytes().fold(0_u64, |hash, byte| {
        hash.wrapping_mul(257).wrapping_add(u64::from(byte))
    });
    pcg::stream(0, name)
}

impl dyn Examiner + '_ {
    /// The exercise's name.
    pub fn name(&self) -> &'static str {
        self.asked().name
    }

    /// What to do.
    pub fn task(&self) -> &'static str {
        self.asked().task
    }

    /// The reference's answer to a question.
    ///
    /// # Errors
    /// If the line is not a question of this exercise.
    pub fn answer_line(&self, question: &str) -> Result<String, RowError> {
        self.asked().answer_line(question)
    }

    /// The named cases of the golden file.
    ///
    /// # Errors
    /// If one cannot be read.
    pub fn named(&self) -> Result<Vec<Named>, GoldenError> {
        golden::named(self.asked(), self.golden())
    }

    /// Named cases and random ones.
    ///
    /// # Errors
    /// If a named case of the golden file cannot be read, or the reference has no answer.
    ///
    /// # Panics
    /// If the exercise's random questions are not fit for it.
    pub fn try_cases(&self, rng: &mut Pcg) -> Result<Cases, CasesError> {
        let mut cases: Vec<Case> = self
            .named()?
            .into_iter()
            .map(|named| {
                let mut case = self.case(&named.name, &named.question)?;
                case.answers.extend(named.also_right);
                Ok(case)
            })
            .collect::<Result<_, CasesError>>()?;
        let (mut kept, mut thrown_away) = (0, 0);
        while kept < RANDOM_CASES {
            let question = self.random(rng);
            if stable::is_stable(self, &question, rng) {
                kept += 1;
                cases.push(self.case(&format!("random {kept}"), &question)?);
            } else {
                thrown_away += 1;
                assert!(
                    thrown_away < 100 * RANDOM_CASES,
                    "{}: hardly any random question has a stable answer",
                    self.name()
                );
            }
        }
        for (case, number) in cases.iter_mut().zip(1..) {
            case.number = number;
        }
        Ok(Cases { cases, thrown_away })
    }

    /// Named cases and random ones of a golden file that can be read.
    ///
    /// # Panics
    /// If it cannot; `try_cases` says why.
    pub fn cases(&self, rng: &mut Pcg) -> Cases {
        let cases = self.try_cases(rng);
        cases.unwrap_or_else(|error| panic!("{}: {error}", self.name()))
    }

    /// A question with the reference's answer; its number comes later.
    fn case(&self, name: &str, question: &[f64]) -> Result<Case, CasesError> {
        let asked = self.asked();
        let answer = self.reference(question).map_err(CasesError::Reference)?;
        Ok(Case {
            number: 0,
            name: name.to_owned(),
            question: row::format(asked.question, question),
            answers: vec![row::format(asked.answer.kind, &answer)],
        })
    }

    /// Judges an answer against the right ones; being any of them is enough.
    ///
    /// # Errors
    /// Why it is wrong, or that it cannot be read.
    pub fn judge(&self, question: &str, answers: &[String], got: &str) -> Verdict {
        let read = |answer: &str| {
            let numbers = self.asked().read_answer(answer);
            numbers.map_err(|e| format!("the answer cannot be read: {e}"))
        };
        let question = self.asked().read_question(question);
        let question = question.map_err(|e| e.to_string())?;
        let got = read(got)?;
        let mut verdict = Err("there is no right answer to compare with".to_owned());
        for golden in answers.iter().rev() {
            verdict = self.verdict(&question, &read(golden)?, &got);
            if verdict.is_ok() {
                break;
            }
        }
        verdict
    }

    /// Judges an answer against a right one.
    ///
    /// # Errors
    /// Why it is wrong.
    pub fn verdict(&self, question: &[f64], golden: &[f64], got: &[f64]) -> Verdict {
        self.compare(question, golden, got)?;
        finite(&self.asked().answer, golden, got)
    }

    /// Judges all answers together that are right one by one.
    ///
    /// # Errors
    /// What is wrong with them.
    pub fn judge_together<'a>(&self, answers: impl Iterator<Item = (&'a str, &'a str)>) -> Verdict {
        let asked = self.asked();
        let read = |(question, answer)| {
            Some((
                asked.read_question(question).ok()?,
                asked.read_answer(answer).ok()?,
            ))
        };
        let rows: Vec<_> = answers.filter_map(read).collect();
        self.compare_together(&rows)
    }

    /// The mistakes' names and hints.
    pub fn mistakes(&self) -> Vec<(&'static str, &'static str)> {
        (0..).map_while(|i| self.mistake(i)).collect()
    }

    /// What mistake number i answers; `None` if the question cannot be read.
    pub fn mistaken(&self, i: usize, question: &str) -> Option<String> {
        let question = self.asked().read_question(question).ok()?;
        let answer = self.mistake_answers(i, &question)?;
        Some(row::format(self.asked().answer.kind, &answer))
    }

    /// The parts of a question, by name.
    pub fn question_parts(&self, question: &str) -> Vec<(String, String)> {
        let asked = self.asked();
        let numbers = asked.read_question(question);
        numbers.map_or_else(
            |_| Vec::new(),
            |numbers| row::parts(asked.question, "question", &numbers),
        )
    }

    /// The parts of an answer, by name; the words themselves if it cannot be read.
    pub fn answer_parts(&self, answer: &str) -> Vec<(String, String)> {
        let asked = self.asked();
        let name = asked.answer.name;
        let numbers = asked.read_answer(answer);
        numbers.map_or_else(
            |_| vec![(name.to_owned(), answer.to_owned())],
            |numbers| row::parts(asked.answer.kind, name, &numbers),
        )
    }

    /// Whether the answer stays right when the question's numbers move in their last digits.
    pub fn is_fair(&self, question: &[f64]) -> bool {
        stable::is_stable(self, question, &mut visible_rng(self.name()))
    }

    /// The pictures that answers make, if any.
    pub fn pictures(&self) -> Vec<PictureSize> {
        (0..).map_while(|i| self.picture(i)).collect()
    }

    /// The question of a pixel of picture number i.
    pub fn pixel_question(&self, i: usize, x: u32, y: u32) -> String {
        let question = self.pixel(i, x, y).unwrap_or_default();
        row::format(self.asked().question, &question)
    }
}
