//! Making cases, judging answers and recognising mistakes, with everything as lines.

use crate::grade::Graded;
use crate::image::rgb::Rgb;
use crate::math::pcg::{self, Pcg};
use crate::workbook::exercise::Asked;
use crate::workbook::row::{self, Row, RowError};
use rand::RngExt;

/// How many random cases an exercise has beside its named ones.
pub const RANDOM_CASES: usize = 34;

/// A random question must keep its answer in so many tries …
const JIGGLES: usize = 8;

/// … of moving each of its numbers by at most so many of its last digits.
const ULPS: i32 = 8;

/// One question with its right answers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Case {
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

/// A picture's size and text.
#[derive(Clone, Copy, Debug)]
pub struct PictureSize {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// What it shows.
    pub alt: &'static str,
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

    /// What mistake number i answers; `None` if it panics or the question cannot be read.
    fn mistaken(&self, i: usize, question: &str) -> Option<String>;

    /// The parts of a question, by name.
    fn question_parts(&self, question: &str) -> Vec<(String, String)>;

    /// The parts of an answer, by name; the words themselves if it cannot be read.
    fn answer_parts(&self, answer: &str) -> Vec<(String, String)>;

    /// The picture that answers make, if any.
    fn picture(&self) -> Option<PictureSize>;

    /// The question of a pixel.
    fn pixel_question(&self, x: u32, y: u32) -> String;

    /// The colour of a pixel's answer; `None` if it cannot be read.
    fn pixel_colour(&self, question: &str, answer: &str) -> Option<Rgb>;
}

/// The random numbers of an exercise's visible cases: the same for everyone, for ever.
pub fn visible_rng(exercise: &str) -> Pcg {
    let name = exercise.bytes().fold(0_u64, |hash, byte| {
        hash.wrapping_mul(257).wrapping_add(u64::from(byte))
    });
    pcg::stream(0, name)
}

impl<E: Graded> Examiner for E {
    fn cases(&self, rng: &mut Pcg) -> Cases {
        let mut cases: Vec<_> = E::edges()
            .into_iter()
            .map(|edge| {
                let also_right = edge.also_right.iter().map(Row::write);
                let answers = std::iter::once(E::answer(&edge.question).write())
                    .chain(also_right)
                    .collect();
                Case {
                    name: edge.name.to_owned(),
                    question: edge.question.write(),
                    answers,
                }
            })
            .collect();
        let (mut kept, mut thrown_away) = (0, 0);
        while kept < RANDOM_CASES {
            let question = E::random(rng);
            if is_stable::<E>(&question, rng) {
                kept += 1;
                let answers = vec![E::answer(&question).write()];
                cases.push(Case {
                    name: format!("random {kept}"),
                    question: question.write(),
                    answers,
                });
            } else {
                thrown_away += 1;
                assert!(
                    thrown_away < 100 * RANDOM_CASES,
                    "{}: hardly any random question has a stable answer",
                    E::NAME
                );
            }
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

    fn question_parts(&self, question: &str) -> Vec<(String, String)> {
        row::read::<E::Question>(question, "question")
            .map_or_else(|_| Vec::new(), |q| q.parts("question"))
    }

    fn answer_parts(&self, answer: &str) -> Vec<(String, String)> {
        let as_it_is = |_| vec![(E::ANSWER.to_owned(), answer.to_owned())];
        row::read::<E::Answer>(answer, E::ANSWER)
            .map_or_else(as_it_is, |answer| answer.parts(E::ANSWER))
    }

    fn picture(&self) -> Option<PictureSize> {
        E::PICTURE.map(|p| PictureSize {
            width: p.width,
            height: p.height,
            alt: p.alt,
        })
    }

    fn pixel_question(&self, x: u32, y: u32) -> String {
        E::PICTURE.map_or_else(String::new, |p| (p.question)(x, y).write())
    }

    fn pixel_colour(&self, question: &str, answer: &str) -> Option<Rgb> {
        let picture = E::PICTURE?;
        Some((picture.colour)(
            &row::read(question, "question").ok()?,
            &row::read(answer, "answer").ok()?,
        ))
    }
}

/// Whether the answer stays right when the question's numbers move in their last digits.
///
/// A ray that grazes a silhouette is nobody's fault.
fn is_stable<E: Graded>(question: &E::Question, rng: &mut Pcg) -> bool {
    let golden = E::answer(question);
    (0..JIGGLES).all(|_| {
        let moved = row::read::<E::Question>(&jiggle(&question.write(), rng), "question");
        moved.is_ok_and(|moved| E::judge(question, &golden, &E::answer(&moved)).is_ok())
    })
}

/// The row with every number that is not whole moved by a few of its last digits.
fn jiggle(row: &str, rng: &mut Pcg) -> String {
    let moved = row
        .split_whitespace()
        .map(|word| match word.parse::<f32>() {
            Ok(v) if v.is_finite() && v.fract() != 0.0 => {
                let bits = v.to_bits() as i32 + rng.random_range(-ULPS..=ULPS);
                f32::from_bits(bits as u32).write()
            }
            _ => word.to_owned(),
        });
    moved.collect::<Vec<_>>().join(" ")
}
