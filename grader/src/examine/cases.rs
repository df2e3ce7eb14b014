//! The cases of an exercise: the named ones of its golden file, and random ones.

use super::Examiner;
use crate::golden::{self, GoldenError, Named, RANDOM};
use crate::stable;
use raybook::math::pcg::{self, Pcg};
use raybook_workbook::row;

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

impl Case {
    /// Whether it was made by chance, and is nothing special.
    pub fn is_random(&self) -> bool {
        self.name.starts_with(RANDOM)
    }
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

/// The random numbers of an exercise's visible cases: the same for everyone, for ever.
pub fn visible_rng(exercise: &str) -> Pcg {
    let name = exercise.bytes().fold(0_u64, |hash, byte| {
        hash.wrapping_mul(257).wrapping_add(u64::from(byte))
    });
    pcg::stream(0, name)
}

impl dyn Examiner + '_ {
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
        let random = self.try_random_cases(rng)?;
        cases.extend(random.cases);
        for (case, number) in cases.iter_mut().zip(1..) {
            case.number = number;
        }
        Ok(Cases { cases, ..random })
    }

    /// The random ones alone; they have no numbers yet.
    ///
    /// # Errors
    /// If the reference has no answer.
    ///
    /// # Panics
    /// If the exercise's random questions are not fit for it.
    pub fn try_random_cases(&self, rng: &mut Pcg) -> Result<Cases, CasesError> {
        let mut cases = Vec::new();
        let (mut kept, mut thrown_away) = (0, 0);
        while kept < RANDOM_CASES {
            let question = self.random(rng);
            if stable::is_stable(self, &question, rng) {
                kept += 1;
                cases.push(self.case(&format!("{RANDOM}{kept}"), &question)?);
            } else {
                thrown_away += 1;
                assert!(
                    thrown_away < 100 * RANDOM_CASES,
                    "{}: hardly any random question has a stable answer",
                    self.name()
                );
            }
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
    pub(crate) fn case(&self, name: &str, question: &[f64]) -> Result<Case, CasesError> {
        let asked = self.asked();
        let answer = self.reference(question).map_err(CasesError::Reference)?;
        Ok(Case {
            number: 0,
            name: name.to_owned(),
            question: row::format(asked.question, question),
            answers: vec![row::format(asked.answer.kind, &answer)],
        })
    }
}
