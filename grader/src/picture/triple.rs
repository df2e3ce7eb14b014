//! The student's picture, the golden one, and the difference with its sign.

use crate::examine::Examiner;
use crate::picture::progressive::MISSING;
use crate::picture::score::Score;
use raybook::image::{Image, rgb::Rgb, rms::rms, tone::to_bytes};
use raybook_chapters::kit::palette;
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_workbook::row;
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

/// What became of a pixel.
struct Pixel {
    yours: Rgb,
    golden: Rgb,
    fate: Fate,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Fate {
    Right,
    Wrong,
    Undecided,
}

/// An answer with the digits that are compared, those of single precision; as it is if it cannot be read.
fn in_digits(examiner: &dyn Examiner, got: &str) -> Untrusted {
    let asked = examiner.asked();
    let read = asked.read_answer(got);
    read.map_or_else(
        |_| got.to_owned(),
        |read| row::format(asked.answer.kind, &read),
    )
    .into()
}

impl Triple {
    /// Whether a display shows any difference.
    pub fn differs(&self) -> bool {
        let bytes = to_bytes(&self.difference);
        bytes.into_iter().any(|byte| byte != u8::MAX)
    }
}

/// The pictures of the answers to the questions of picture number `picture`.
pub fn triple(
    examiner: &dyn Examiner,
    picture: usize,
    size: PictureSize,
    answers: &[Option<String>],
) -> Triple {
    let (width, height) = (size.width as usize, size.height as usize);
    let asked = examiner.asked();
    let question = |i: usize| {
        let (x, y) = (i as u32 % size.width, i as u32 / size.width);
        examiner.pixel(picture, x, y).unwrap_or_default()
    };
    let pixel = |i: usize| {
        let question = question(i);
        let golden = (asked.call)(&question);
        let got = answers[i]
            .as_ref()
            .and_then(|got| asked.read_answer(got).ok());
        let right = got
            .as_ref()
            .is_some_and(|got| examiner.verdict(&question, &golden, got).is_ok());
        // Of the wrong ones only: a ray that grazes a silhouette is nobody's fault.
        let fate = if right {
            Fate::Right
        } else if answers[i].is_none() || examiner.is_fair(&question) {
            Fate::Wrong
        } else {
            Fate::Undecided
        };
        let colour = |answer: &[f64]| examiner.colour(picture, &question, answer);
        Pixel {
            yours: got.and_then(|got| colour(&got)).unwrap_or(MISSING),
            golden: colour(&golden).unwrap_or(MISSING),
            fate,
        }
    };
    let pixels: Vec<_> = (0..width * height).into_par_iter().map(pixel).collect();
    let at = |x: usize, y: usize| &pixels[y * width + x];
    let yours = Image::from_fn(width, height, |x, y| at(x, y).yours);
    let golden = Image::from_fn(width, height, |x, y| at(x, y).golden);
    let difference = Image::from_fn(width, height, |x, y| {
        palette::signed(yours.at(x, y).luminance() - golden.at(x, y).luminance())
    });
    let first_bad = pixels.iter().position(|pixel| pixel.fate == Fate::Wrong);
    let first_bad = first_bad.map(|i| {
        let question = question(i);
        BadPixel {
            x: i % width,
            y: i / width,
            golden: row::format(asked.answer.kind, &(asked.call)(&question)),
            question: examiner.pixel_question(
                picture,
                i as u32 % size.width,
                i as u32 / size.width,
            ),
            got: answers[i].as_deref().map(|got| in_digits(examiner, got)),
        }
    });
    let count = |fate| pixels.iter().filter(|pixel| pixel.fate == fate).count();
    let undecided = count(Fate::Undecided);
    let score = Score {
        right: count(Fate::Right),
        of: pixels.len() - undecided,
        undecided,
        error: rms(&golden, &yours, |x, y| at(x, y).fate != Fate::Undecided),
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
