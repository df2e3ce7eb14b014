//! Pictures made of answers: the student's, the golden one, and the difference with its sign.

use crate::grade::ask::{Said, understand};
use crate::grade::converse::{Conversation, Limits, Program, converse};
use crate::grade::examine::{Examiner, PictureSize};
use crate::image::{Image, rgb::Rgb};
use std::io;

/// Three pictures of the same pixels.
#[derive(Clone, Debug)]
pub struct Triple {
    /// Of the student's answers; magenta where there is none.
    pub yours: Image,
    /// Of the golden answers.
    pub golden: Image,
    /// Yours minus golden in luminance: orange where yours is brighter, blue where it is darker, white where equal.
    pub difference: Image,
    /// The first wrong pixel in reading order.
    pub first_bad: Option<BadPixel>,
    /// How many pixels are wrong.
    pub bad: usize,
    /// What the picture shows.
    pub alt: &'static str,
}

/// A pixel whose answer is wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BadPixel {
    /// Column.
    pub x: usize,
    /// Row.
    pub y: usize,
    /// The pixel's question, without the exercise's name.
    pub question: String,
    /// The golden answer.
    pub golden: String,
    /// The student's answer, or `None` without one.
    pub got: Option<String>,
}

/// Where there is no answer.
const MISSING: Rgb = Rgb::new(0.8, 0.0, 0.8);

/// Asks the program a question per pixel; `None` if the exercise has no picture.
///
/// A program that breaks on the way gets no more questions.
///
/// # Errors
/// If the program cannot be started.
pub fn ask_pixels(
    program: &Program,
    examiner: &dyn Examiner,
    limits: Limits,
) -> io::Result<Option<Triple>> {
    let questions = pixel_questions(examiner);
    if questions.is_empty() {
        return Ok(None);
    }
    let asked: Vec<_> = questions
        .iter()
        .map(|question| format!("{} {question}", examiner.name()))
        .collect();
    let Conversation { answers, .. } = converse(program, &asked, limits)?;
    let mut answers: Vec<_> = answers
        .into_iter()
        .map(|(answer, _)| match understand(&answer) {
            Said::Answer(answer) => Some(answer),
            _ => None,
        })
        .collect();
    answers.resize(questions.len(), None);
    Ok(triple(examiner, &answers))
}

/// The questions of the pixels in reading order; none if the exercise has no picture.
pub fn pixel_questions(examiner: &dyn Examiner) -> Vec<String> {
    let Some(PictureSize { width, height, .. }) = examiner.picture() else {
        return Vec::new();
    };
    (0..width * height)
        .map(|i| examiner.pixel_question(i % width, i / width))
        .collect()
}

/// The pictures of the answers to [`pixel_questions`]; `None` if the exercise has no picture.
pub fn triple(examiner: &dyn Examiner, answers: &[Option<String>]) -> Option<Triple> {
    let PictureSize { width, height, alt } = examiner.picture()?;
    let (width, height) = (width as usize, height as usize);
    let questions = pixel_questions(examiner);
    let golden: Vec<_> = questions
        .iter()
        .map(|question| examiner.answer_line(question).unwrap_or_default())
        .collect();
    let right = |i: usize| {
        let judge = |got: &String| examiner.judge(&questions[i], &golden[i..=i], got).is_ok();
        answers[i].as_ref().is_some_and(judge)
    };
    let bad: Vec<_> = (0..questions.len()).filter(|&i| !right(i)).collect();
    let colour = |i: usize, answer: Option<&String>| {
        answer
            .and_then(|answer| examiner.pixel_colour(&questions[i], answer))
            .unwrap_or(MISSING)
    };
    let at = |x: usize, y: usize| y * width + x;
    let yours = Image::from_fn(width, height, |x, y| {
        colour(at(x, y), answers[at(x, y)].as_ref())
    });
    let right = Image::from_fn(width, height, |x, y| {
        colour(at(x, y), Some(&golden[at(x, y)]))
    });
    let difference = Image::from_fn(width, height, |x, y| {
        signed(yours.at(x, y).luminance() - right.at(x, y).luminance())
    });
    let first_bad = bad.first().map(|&i| BadPixel {
        x: i % width,
        y: i / width,
        question: questions[i].clone(),
        golden: golden[i].clone(),
        got: answers[i].clone(),
    });
    Some(Triple {
        yours,
        golden: right,
        difference,
        first_bad,
        bad: bad.len(),
        alt,
    })
}

/// White for 0, towards orange above, towards blue below; full colour from a difference of a quarter on.
fn signed(difference: f32) -> Rgb {
    let amount = (4.0 * difference.abs()).clamp(0.0, 1.0).sqrt();
    let full = if difference > 0.0 {
        Rgb::new(0.79, 0.35, 0.0)
    } else {
        Rgb::new(0.0, 0.17, 0.45)
    };
    Rgb::WHITE.lerp(full, if difference.is_nan() { 1.0 } else { amount })
}
