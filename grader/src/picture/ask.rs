//! Pictures made of answers: a question per pixel.

use crate::ask::{Asker, Reply, Said};
use crate::examine::{Case, Examiner};
use crate::picture::triple::{PictureSize, Triple, triple};
use rand::RngExt;
use raybook::math::pcg;
use raybook_workbook::row;
use std::io;

/// Which pixels of an exercise's pictures are asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pixels {
    /// None: a single case is asked.
    None,
    /// One in `STRETCH`, where no picture is wanted, and all of them only if one of these is wrong.
    Some,
    /// As `Some`, and of who is wrong, in cases or in these pixels, picture by picture up to the first that is not passed.
    FirstWrong,
    /// All, for a picture that is looked at.
    All,
    /// As `Some` of who is right, whose picture was drawn before, and all of others. Which pixels, depends on the number too: another
    /// number at each check, and what is wrong in few of them is found by one of the next checks.
    Renewed(u64),
}

/// One pixel of this number in reading order is asked, where no picture is wanted: 144 of each scene of `trace`. With 5 % of a
/// picture's rays wrong, all of 144 are right once in 1600 times.
pub const STRETCH: usize = 24;

/// Asks the program a question per pixel of all the exercise's pictures.
///
/// A program that keeps silent, or uses up a total limit, gets no more questions, and why is returned beside the pictures.
///
/// # Errors
/// If the program cannot be started.
pub fn ask_pixels(
    asker: &mut Asker<'_>,
    examiner: &dyn Examiner,
) -> io::Result<(Vec<Triple>, Option<String>)> {
    let (answers, stopped) = ask(asker, examiner, &pixel_questions(examiner))?;
    Ok((triples(examiner, &answers), stopped))
}

/// Asks the program picture by picture, until one is not passed or it goes on no more; why, is returned beside the pictures.
///
/// # Errors
/// If the program cannot be started.
pub fn ask_to_first_wrong(
    asker: &mut Asker<'_>,
    examiner: &dyn Examiner,
) -> io::Result<(Vec<Triple>, Option<String>)> {
    let mut pictures = Vec::new();
    for (number, size) in examiner.pictures().into_iter().enumerate() {
        let questions: Vec<_> = questions_of(examiner, number, size).collect();
        let (answers, stopped) = ask(asker, examiner, &questions)?;
        let picture = triple(examiner, number, size, &answers);
        let is_last = stopped.is_some() || !picture.score.passed();
        pictures.push(picture);
        if is_last {
            return Ok((pictures, stopped));
        }
    }
    Ok((pictures, None))
}

/// Asks the program some pixels of all the exercise's pictures, and returns whether all are right. Which they are follows from
/// the cases, and from `round`: who cannot foresee these cannot foresee the pixels.
///
/// # Errors
/// If the program cannot be started.
pub fn some_are_right(
    asker: &mut Asker<'_>,
    examiner: &dyn Examiner,
    cases: &[Case],
    round: u64,
) -> io::Result<bool> {
    let questions = some_questions(examiner, cases, round);
    let line = |question: &Vec<f64>| row::format(examiner.asked().question, question);
    let lines: Vec<_> = questions.iter().map(line).collect();
    let (answers, _) = ask(asker, examiner, &lines)?;
    let is_right = |question: &[f64], got: &str| examiner.is_right_line(question, got);
    let mut asked = questions.iter().zip(&answers);
    Ok(asked.all(|(question, got)| got.as_ref().is_some_and(|got| is_right(question, got))))
}

/// The questions of some pixels, in numbers: one of each stretch of `STRETCH`.
pub fn some_questions(examiner: &dyn Examiner, cases: &[Case], round: u64) -> Vec<Vec<f64>> {
    let bytes = cases.iter().flat_map(|case| case.question.bytes());
    let seed = bytes.fold(0_u64, |seed, byte| {
        seed.wrapping_mul(257).wrapping_add(u64::from(byte))
    });
    let mut rng = pcg::stream(seed, round);
    let mut questions = Vec::new();
    for (picture, PictureSize { width, height, .. }) in examiner.pictures().into_iter().enumerate()
    {
        for first in (0..width * height).step_by(STRETCH) {
            let i = (first + rng.random_range(0..STRETCH as u32)).min(width * height - 1);
            questions.push(examiner.pixel_numbers(picture, i % width, i / width));
        }
    }
    questions
}

/// The program's answers to questions of pixels, `None` where there is none, and why it broke off, if it did.
fn ask(
    asker: &mut Asker<'_>,
    examiner: &dyn Examiner,
    questions: &[String],
) -> io::Result<(Vec<Option<String>>, Option<String>)> {
    if questions.is_empty() {
        return Ok((Vec::new(), None));
    }
    let asked: Vec<_> = questions
        .iter()
        .map(|question| format!("{} {question}", examiner.name()))
        .collect();
    let replies = asker.ask_many(&asked)?;
    let stopped = stopped(&replies);
    let answers: Vec<_> = replies
        .into_iter()
        .map(|reply| match reply.said {
            Said::Answer(answer) => Some(answer.unescaped().to_owned()),
            _ => None,
        })
        .collect();
    Ok((answers, stopped))
}

/// Why not all was asked, if so: what was wrong before, and that.
fn stopped(replies: &[Reply]) -> Option<String> {
    let why = |reply: &Reply| Some(reply.said.why_none()? + reply.said.help());
    let first = replies.iter().position(|reply| reply.said.is_left_out())?;
    let before = replies[..first].last().and_then(why);
    let why = why(&replies[first])?;
    Some(before.map_or_else(
        || why.clone(),
        |before| format!("{before}; the others were {why}"),
    ))
}

/// The questions of the pixels in reading order, one picture after the other; none if the exercise has no picture.
pub fn pixel_questions(examiner: &dyn Examiner) -> Vec<String> {
    let pictures = examiner.pictures().into_iter().enumerate();
    let questions = pictures.flat_map(|(number, size)| questions_of(examiner, number, size));
    questions.collect()
}

/// The questions of the pixels of picture `number` in reading order.
fn questions_of(
    examiner: &dyn Examiner,
    number: usize,
    PictureSize { width, height, .. }: PictureSize,
) -> impl Iterator<Item = String> {
    (0..width * height).map(move |i| examiner.pixel_question(number, i % width, i / width))
}

/// The pictures of the answers to [`pixel_questions`].
pub fn triples(examiner: &dyn Examiner, answers: &[Option<String>]) -> Vec<Triple> {
    let mut rest = answers;
    let pictures = examiner.pictures().into_iter().enumerate();
    let triples = pictures.map(|(picture, size)| {
        let (of_picture, others) = rest.split_at((size.width * size.height) as usize);
        rest = others;
        triple(examiner, picture, size, of_picture)
    });
    triples.collect()
}
