//! The case that is to be explained, asked: one of the exercise's own, or the question of a pixel.

use super::account::Account;
use crate::ask::Asker;
use crate::check::{Mark, Outcome, Report, check};
use crate::examine::{Case, Examiner, visible_rng};
use raybook_chapters::kit::untrusted::Untrusted;
use std::io;

/// Which case of an exercise is to be explained.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Which {
    /// The first that the program answers wrong, or else the first.
    FirstWrong,
    /// That of this number, from 1.
    Case(usize),
    /// The question of a pixel of the exercise's picture: its column and its row from the top left, from 0.
    Pixel([u32; 2]),
}

/// Why there is nothing to explain.
#[derive(Debug, thiserror::Error)]
pub enum AskedError {
    /// There is no such case, or no such pixel.
    #[error("{0}")]
    NotThere(String),
    /// The program cannot be asked.
    #[error(transparent)]
    Io(#[from] io::Error),
}

/// An exercise that was asked, and the case that is to be explained.
pub struct Asked {
    examiner: &'static dyn Examiner,
    report: Report,
    /// Which of the report's cases, from 0.
    chosen: usize,
}

impl Asked {
    /// Asks the program all cases of an exercise, for a mistake shows in several of them, and the pixel's question if that is wanted.
    ///
    /// # Errors
    /// If the exercise has no such case or pixel, or the program cannot be asked.
    pub fn new(
        asker: &mut Asker<'_>,
        examiner: &'static dyn Examiner,
        which: Which,
    ) -> Result<Self, AskedError> {
        let name = examiner.name();
        let mut cases = examiner.cases(&mut visible_rng(name)).cases;
        let count = cases.len();
        let chosen = match which {
            Which::FirstWrong => None,
            Which::Case(number) if (1..=count).contains(&number) => Some(number - 1),
            Which::Case(number) => {
                let why = format!("{name} has {count} cases, there is no case {number}");
                return Err(AskedError::NotThere(why));
            }
            Which::Pixel(pixel) => {
                cases.push(of_pixel(examiner, count + 1, pixel).map_err(AskedError::NotThere)?);
                Some(count)
            }
        };
        let report = check(asker, examiner, cases)?;
        let is_wrong = |outcome: &Outcome| matches!(outcome.verdict, Mark::Wrong(_));
        let chosen = chosen.or_else(|| report.cases.iter().position(is_wrong));
        Ok(Self {
            examiner,
            chosen: chosen.unwrap_or(0),
            report,
        })
    }

    /// What became of the case; none if the exercise has no cases.
    pub fn outcome(&self) -> Option<&Outcome> {
        self.report.cases.get(self.chosen)
    }

    /// Everything that is known of the case.
    pub fn account(&self) -> Option<Account<'_>> {
        Some(Account::of(&self.report, self.examiner, self.outcome()?))
    }
}

/// The question of a pixel as a case, or why there is none.
fn of_pixel(examiner: &dyn Examiner, number: usize, [x, y]: [u32; 2]) -> Result<Case, String> {
    let name = examiner.name();
    let size = examiner
        .picture(0)
        .ok_or_else(|| format!("{name} has no picture; --case chooses one of its cases"))?;
    let (width, height) = (size.width, size.height);
    if x >= width || y >= height {
        return Err(format!(
            "the picture of {name} has {width} columns and {height} rows: there is no pixel {x},{y}"
        ));
    }
    let question = examiner.pixel_question(0, x, y);
    let answer = examiner
        .answer_line(&question)
        .map_err(|error| error.to_string())?;
    Ok(Case {
        number,
        name: format!("the pixel in column {x} of row {y} of the picture"),
        question,
        answers: vec![answer],
    })
}

/// A pixel's column and row, as they are typed: `63,40`.
///
/// # Errors
/// If the text is none.
pub fn pixel(text: &str) -> Result<[u32; 2], String> {
    let wrong = || {
        let text = Untrusted::from(text);
        format!("`{text}` is no pixel: its column and its row are wanted, for example 63,40")
    };
    let (x, y) = text.split_once(',').ok_or_else(wrong)?;
    let number = |word: &str| word.trim().parse().map_err(|_| wrong());
    Ok([number(x)?, number(y)?])
}
