//! Text as lines of words that know where they stand, for files that people write and break.

use crate::math::domain::LARGEST;
use crate::memory::{BUDGET, gigabytes};
use crate::shape::mesh::MeshError;
use glam::Vec3;

/// What a corner of a face looks like.
pub const INDICES: &str = "indices, as in 3, 3/1, 3//2 or 3/1/2";

/// Most words of a line: what follows is not looked at, for words take many times the memory of their text.
pub const MOST_WORDS: usize = 1 << 20;

/// A word of a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Word<'a> {
    /// The word itself, without white space.
    pub text: &'a str,
    /// Its line, from 1.
    pub line: usize,
    /// Where it begins, in characters from 1.
    pub column: usize,
}

/// Something wrong in a text, and where.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{line}:{column}: {reason}")]
pub struct Wrong {
    /// The line, from 1.
    pub line: usize,
    /// The column, in characters from 1.
    pub column: usize,
    /// What is wrong there.
    pub reason: Reason,
}

/// What can be wrong with a line of a mesh.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Reason {
    /// Letters where a number should be.
    #[error("expected a number, found `{0}`")]
    NotANumber(String),
    /// NaN, infinity, or a number beyond the 3.4e38 of an `f32`.
    #[error("expected a finite number, found `{0}`")]
    NotFinite(String),
    /// A coordinate outside the domain.
    #[error("expected a coordinate of at most {LARGEST:e} m, found `{0}`; make the mesh smaller")]
    TooFar(String),
    /// The whole text does not make a mesh.
    #[error("{0}")]
    Mesh(MeshError),
    /// Too few or too many numbers or words after a keyword.
    #[error("{what} needs {needs}, and here are {found}")]
    Count {
        /// What the line describes.
        what: &'static str,
        /// How many it needs, in words.
        needs: &'static str,
        /// How many there are.
        found: usize,
    },
    /// Not the form of an index.
    #[error("expected {expected}, found `{found}`")]
    Expected {
        /// What should stand here.
        expected: &'static str,
        /// What stands here.
        found: String,
    },
    /// A number that is given to nothing.
    #[error("there is no {what} {index}: above this line are {given}, counted from 1")]
    Index {
        /// What is numbered.
        what: &'static str,
        /// The number.
        index: i64,
        /// How many there are so far.
        given: usize,
    },
    /// A number of a vertex, counted from 0, that is given to none.
    #[error("there is no vertex {index}: the file has {given}, and the first is 0")]
    FromZero {
        /// The number, as it stands there.
        index: String,
        /// How many vertices there are.
        given: u64,
    },
    /// More faces and vertices than the budget of memory allows.
    #[error("up to here the mesh takes {} of memory, and a mesh may take {}; make it coarser, or cut it up", gigabytes(*.0), gigabytes(BUDGET))]
    TooLarge(u64),
    /// The text ends too early.
    #[error("the file ends, but {0} is missing")]
    End(&'static str),
}

impl Wrong {
    /// The whole text is wrong: it does not make a mesh.
    pub(crate) fn as_mesh(error: MeshError) -> Self {
        Self {
            line: 1,
            column: 1,
            reason: Reason::Mesh(error),
        }
    }
}

impl Word<'_> {
    /// What is wrong with this word.
    pub fn wrong(&self, reason: Reason) -> Wrong {
        Wrong {
            line: self.line,
            column: self.column,
            reason,
        }
    }

    /// What should have stood here instead.
    pub fn expected(&self, expected: &'static str) -> Wrong {
        self.wrong(Reason::Expected {
            expected,
            found: self.text.to_owned(),
        })
    }

    /// The word as a finite number.
    ///
    /// # Errors
    /// If it is something else; NaN and infinity have spellings that Rust reads, so they are looked for.
    pub fn number(&self) -> Result<f32, Wrong> {
        let number: f32 = self
            .text
            .parse()
            .map_err(|_| self.wrong(Reason::NotANumber(self.text.to_owned())))?;
        if number.is_finite() {
            Ok(number)
        } else {
            Err(self.wrong(Reason::NotFinite(self.text.to_owned())))
        }
    }

    /// A part of the word as an index from 0 into `given` things that are counted from 1; −1 is the last of them.
    ///
    /// # Errors
    /// If it is not a whole number, or counts to nothing.
    pub fn index(&self, part: &str, what: &'static str, given: usize) -> Result<usize, Wrong> {
        let index: i64 = part.parse().map_err(|_| self.expected(INDICES))?;
        let from_zero = if index < 0 {
            given as i64 + index
        } else {
            index - 1
        };
        usize::try_from(from_zero)
            .ok()
            .filter(|&i| i < given)
            .ok_or_else(|| self.wrong(Reason::Index { what, index, given }))
    }
}

/// The lines that hold words, without what follows a `#`; a `\` at its end joins a line with the next.
pub fn lines(text: &str) -> impl Iterator<Item = Vec<Word<'_>>> {
    // Some editors begin a file with this mark, and the first word would not be known.
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut numbered = (1..).zip(text.lines());
    std::iter::from_fn(move || {
        let mut words = Vec::new();
        for (number, line) in numbered.by_ref() {
            let content = line.split('#').next().unwrap_or_default().trim_end();
            let joined = content.strip_suffix('\\');
            push_words(joined.unwrap_or(content), number, &mut words);
            if joined.is_none() && !words.is_empty() {
                return Some(words);
            }
        }
        (!words.is_empty()).then_some(words)
    })
}

/// The words of one line, whose number is given.
pub fn words(line: &str, number: usize) -> Vec<Word<'_>> {
    let mut words = Vec::new();
    push_words(line, number, &mut words);
    words
}

fn push_words<'a>(line: &'a str, number: usize, words: &mut Vec<Word<'a>>) {
    let (mut column, mut rest) = (1, line);
    for text in line.split_whitespace() {
        if words.len() > MOST_WORDS {
            return;
        }
        let before = rest.find(text).unwrap_or_default();
        column += rest[..before].chars().count();
        words.push(Word {
            text,
            line: number,
            column,
        });
        column += text.chars().count();
        rest = &rest[before + text.len()..];
    }
}

/// The name that follows a keyword: all that follows, for there may be spaces in it.
pub fn name(words: &[Word]) -> String {
    let words: Vec<_> = words[1..].iter().map(|word| word.text).collect();
    words.join(" ")
}

/// The place of a vertex: the first three of the numbers that follow a keyword.
///
/// # Errors
/// Those of [`numbers`]; and if a coordinate is outside the [domain](crate::math::domain).
pub fn place(
    words: &[Word],
    allowed: std::ops::RangeInclusive<usize>,
    what: &'static str,
    needs: &'static str,
) -> Result<Vec3, Wrong> {
    let n = numbers(words, allowed, what, needs)?;
    let place = Vec3::from_slice(&n);
    match (0..3).find(|&axis| place[axis].abs() > LARGEST) {
        Some(axis) => {
            let word = &words[1 + axis];
            Err(word.wrong(Reason::TooFar(word.text.to_owned())))
        }
        None => Ok(place),
    }
}

/// The finite numbers that follow a keyword: as many as `allowed`.
///
/// # Errors
/// If there are fewer or more, or a word is not a finite number.
pub fn numbers(
    words: &[Word],
    allowed: std::ops::RangeInclusive<usize>,
    what: &'static str,
    needs: &'static str,
) -> Result<Vec<f32>, Wrong> {
    let rest = &words[1..];
    if !allowed.contains(&rest.len()) {
        return Err(words[0].wrong(Reason::Count {
            what,
            needs,
            found: rest.len(),
        }));
    }
    rest.iter().map(Word::number).collect()
}
