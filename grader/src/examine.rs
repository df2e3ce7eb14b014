//! Making cases, judging answers and recognising mistakes, with everything as lines.

use crate::triple::PictureSize;
use crate::{Graded, Picture, stable};
use raybook::image::rgb::Rgb;
use raybook::math::pcg::{self, Pcg};
use raybook_workbook::exercise::Asked;
use raybook_workbook::row::{self, Row, RowError};

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

/// A graded exercise whose types are forgotten.
pub trait Examiner: Asked {
    /// Named cases and random ones.
    fn cases(&self, rng: &mut Pcg) -> Cases;

    /// Judges an answer against the right ones; being any of them is enough.
    ///
    /// # Errors
    /// Why it is wrong, or that it cannot be read.
    fn judge(&self, question: &str, answers: &[String], got: &str) -> Result<(), String>;

    /// The mistakes' names and hints.
    fn mistakes(&self) -> Vec<(&'static str, &'static str)>;

    /// What mistake number i answers; `None` if the question cannot be read.
    fn mistaken(&self, i: usize, question: &str) -> Option<String>;

    /// How close an answer to a mistake's is that mistake, relatively.
    fn alike(&self) -> f32;

    /// The parts of a question, by name.
    fn question_parts(&self, question: &str) -> Vec<(String, String)>;

    /// The parts of an answer, by name; the words themselves if it cannot be read.
    fn answer_parts(&self, answer: &str) -> Vec<(String, String)>;

    /// Whether the answer stays right when the question's numbers move in their last digits.
    fn is_fair(&self, question: &str) -> bool;

    /// The pictures that answers make, if any.
    fn pictures(&self) -> Vec<PictureSize>;

    /// The question of a pixel of picture number i.
    fn pixel_question(&self, i: usize, x: u32, y: u32) -> String;

    /// The colour of a pixel's answer in picture number i; `None` if it cannot be read.
    fn pixel_colour(&self, i: usize, question: &str, answer: &str) -> Option<Rgb>;
}

/// The random numbers of an exercise's visible cases: the same for everyone, for ever.
pub fn visible_rng(exercise: &str) -> Pcg {
    let name = exercise.bytes().fold(0_u64, |hash, byte| {
        hash.wrapping_mul(257).wrapping_add(u64::from(byte))
    });
    pcg::stream(0, name)
}

/// A question with the reference's answer; its number comes later.
fn case<E: Graded>(name: &str, question: &E::Question) -> Case {
    Case {
        number: 0,
        name: name.to_owned(),
        question: question.write(),
        answers: vec![E::answer(question).write()],
    }
}

impl<E: Graded> Examiner for E {
    fn cases(&self, rng: &mut Pcg) -> Cases {
        let mut cases: Vec<_> = E::edges()
            .into_iter()
            .map(|edge| {
                let mut case = case::<E>(edge.name, &edge.question);
                case.answers.extend(edge.also_right.iter().map(Row::write));
                case
            })
            .collect();
        let (mut kept, mut thrown_away) = (0, 0);
        while kept < RANDOM_CASES {
            let question = E::random(rng);
            if stable::is_stable::<E>(&question, rng) {
                kept += 1;
                cases.push(case::<E>(&format!("random {kept}"), &question));
            } else {
                thrown_away += 1;
                assert!(
                    thrown_away < 100 * RANDOM_CASES,
                    "{}: hardly any random question has a stable answer",
                    E::NAME
                );
            }
        }
        for (case, number) in cases.iter_mut().zip(1..) {
            case.number = number;
        }
        Cases { cases, thrown_away }
    }

    fn judge(&self, question: &str, answers: &[String], got: &str) -> Result<(), String> {
        let read_error = |e: RowError| format!("the answer cannot be read: {e}");
        let question: E::Question = row::read(question, "question").map_err(|e| e.to_string())?;
        let got: E::Answer = row::read(got, E::ANSWER).map_err(read_error)?;
        let mut verdict = Err("there is no right answer to compare with".to_owned());
        for golden in answers.iter().rev() {
            let golden: E::Answer = row::read(golden, E::ANSWER).map_err(read_error)?;
            verdict = E::judge(&question, &golden, &got);
            if verdict.is_ok() {
                break;
            }
        }
        verdict
    }

    fn mistakes(&self) -> Vec<(&'static str, &'static str)> {
        E::MISTAKES
            .iter()
            .map(|mistake| (mistake.name, mistake.hint))
            .collect()
    }

    fn mistaken(&self, i: usize, question: &str) -> Option<String> {
        let question = row::read(question, "question").ok()?;
        Some((E::MISTAKES.get(i)?.answer)(&question).write())
    }

    fn alike(&self) -> f32 {
        E::ALIKE
    }

    fn question_parts(&self, question: &str) -> Vec<(String, String)> {
        row::read::<E::Question>(question, "question")
            .map_or_else(|_| Vec::new(), |q| q.parts("question"))
    }

    fn answer_parts(&self, answer: &str) -> Vec<(String, String)> {
        let as_it_is = |_| vec![(E::ANSWER.to_owned(), answer.to_owned())];
        row::read::<E::Answer>(answer, E::ANSWER)
            .map_or_else(as_it_is, |answer| answer.parts(E::ANSWER))
    }

    fn is_fair(&self, question: &str) -> bool {
        row::read(question, "question")
            .is_ok_and(|question| stable::is_stable::<E>(&question, &mut visible_rng(E::NAME)))
    }

    fn pictures(&self) -> Vec<PictureSize> {
        let size = |p: &Picture<E>| PictureSize {
            name: p.name,
            width: p.width,
            height: p.height,
            alt: p.alt,
        };
        E::PICTURES.iter().map(size).collect()
    }

    fn pixel_question(&self, i: usize, x: u32, y: u32) -> String {
        let picture = E::PICTURES.get(i);
        picture.map_or_else(String::new, |p| (p.question)(x, y).write())
    }

    fn pixel_colour(&self, i: usize, question: &str, answer: &str) -> Option<Rgb> {
        Some((E::PICTURES.get(i)?.colour)(
            &row::read(question, "question").ok()?,
            &row::read(answer, "answer").ok()?,
        ))
    }
}
