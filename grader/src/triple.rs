//! The student's picture, the golden one, and the difference with its sign.

use crate::examine::Examiner;
use crate::score::Score;
use raybook::image::{Image, rgb::Rgb, rms::rms};
use raybook_chapters::kit::palette;
use raybook_chapters::kit::untrusted::Untrusted;
use rayon::prelude::{IntoParallelIterator, ParallelIterator};

/// A picture's size and text.
#[derive(Clone, Copy, Debug)]
pub struct PictureSize {
    /// What it is called.
    pub name: &'static str,
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// What it shows.
    pub alt: &'static str,
}

/// Three pictures of the same pixels.
#[derive(Clone, Debug)]
pub struct Triple {
    /// What the picture is called, among an exercise's.
    pub name: &'static str,
    /// Of the student's answers; magenta where there is none.
    pub yours: Image,
    /// Of the golden answers.
    pub golden: Image,
    /// Yours minus golden in luminance: orange where yours is brighter, blue where it is darker, white where equal.
    pub difference: Image,
    /// The first wrong pixel in reading order.
    pub first_bad: Option<BadPixel>,
    /// How good it is.
    pub score: Score,
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
    pub got: Option<Untrusted>,
}

/// Where there is no answer.
const MISSING: Rgb = Rgb::new(0.8, 0.0, 0.8);

/// What became of a pixel.
struct Pixel {
    question: String,
    golden: String,
    verdict: Fate,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Fate {
    Right,
    Wrong,
    Undecided,
}

/// The pictures of the answers to the questions of picture number `picture`.
pub fn triple(
    examiner: &dyn Examiner,
    picture: usize,
    size: PictureSize,
    answers: &[Option<String>],
) -> Triple {
    let (width, height) = (size.width as usize, size.height as usize);
    let pixel = |i: usize| {
        let question =
            examiner.pixel_question(picture, i as u32 % size.width, i as u32 / size.width);
        let golden = examiner.answer_line(&question).unwrap_or_default();
        let right = answers[i].as_ref().is_some_and(|got| {
            let golden = std::slice::from_ref(&golden);
            examiner.judge(&question, golden, got).is_ok()
        });
        // Of the wrong ones only: a ray that grazes a silhouette is nobody's fault.
        let verdict = if right {
            Fate::Right
        } else if answers[i].is_none() || examiner.is_fair(&question) {
            Fate::Wrong
        } else {
            Fate::Undecided
        };
        Pixel {
            question,
            golden,
            verdict,
        }
    };
    let pixels: Vec<_> = (0..width * height).into_par_iter().map(pixel).collect();
    let colour = |i: usize, answer: Option<&String>| {
        answer
            .and_then(|answer| examiner.pixel_colour(picture, &pixels[i].question, answer))
            .unwrap_or(MISSING)
    };
    let at = |x: usize, y: usize| y * width + x;
    let yours = Image::from_fn(width, height, |x, y| {
        colour(at(x, y), answers[at(x, y)].as_ref())
    });
    let golden = Image::from_fn(width, height, |x, y| {
        colour(at(x, y), Some(&pixels[at(x, y)].golden))
    });
    let difference = Image::from_fn(width, height, |x, y| {
        palette::signed(yours.at(x, y).luminance() - golden.at(x, y).luminance())
    });
    let first_bad = pixels.iter().position(|pixel| pixel.verdict == Fate::Wrong);
    let first_bad = first_bad.map(|i| BadPixel {
        x: i % width,
        y: i / width,
        question: pixels[i].question.clone(),
        golden: pixels[i].golden.clone(),
        got: answers[i].clone().map(Untrusted::from),
    });
    let count = |verdict| {
        pixels
            .iter()
            .filter(|pixel| pixel.verdict == verdict)
            .count()
    };
    let undecided = count(Fate::Undecided);
    let score = Score {
        right: count(Fate::Right),
        of: pixels.len() - undecided,
        undecided,
        error: rms(&golden, &yours, |x, y| {
            pixels[at(x, y)].verdict != Fate::Undecided
        }),
    };
    Triple {
        name: size.name,
        yours,
        golden,
        difference,
        first_bad,
        score,
        alt: size.alt,
    }
}
