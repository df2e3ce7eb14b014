//! Pictures made of answers: a question per pixel.

use crate::ask::{Asker, Said, silence, understand};
use crate::converse::Conversation;
use crate::examine::Examiner;
use crate::triple::{PictureSize, Triple, triple};
use std::io;

/// Asks the program a question per pixel of all the exercise's pictures, in one conversation.
///
/// A program that breaks on the way gets no more questions, and why is returned beside the pictures.
///
/// # Errors
/// If the program cannot be started.
pub fn ask_pixels(
    asker: &mut Asker<'_>,
    examiner: &dyn Examiner,
) -> io::Result<(Vec<Triple>, Option<String>)> {
    let questions = pixel_questions(examiner);
    if questions.is_empty() {
        return Ok((Vec::new(), None));
    }
    let asked: Vec<_> = questions
        .iter()
        .map(|question| format!("{} {question}", examiner.name()))
        .collect();
    let Conversation { answers, end, .. } = asker.converse(&asked)?;
    let all = answers.len() >= questions.len();
    let stopped = end.filter(|_| !all).and_then(|end| silence(end).why_none());
    let mut answers: Vec<_> = answers
        .into_iter()
        .map(|(answer, _)| match understand(&answer) {
            Said::Answer(answer) => Some(answer),
            _ => None,
        })
        .collect();
    answers.resize(questions.len(), None);
    Ok((triples(examiner, &answers), stopped))
}

/// The questions of the pixels in reading order, one picture after the other; none if the exercise has no picture.
pub fn pixel_questions(examiner: &dyn Examiner) -> Vec<String> {
    let pictures = examiner.pictures().into_iter().enumerate();
    let questions = pictures.flat_map(|(picture, PictureSize { width, height, .. })| {
        (0..width * height).map(move |i| examiner.pixel_question(picture, i % width, i / width))
    });
    questions.collect()
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
