//! Text as lines of words that know their places, for files that are written by hand and may contain errors.
//!
//! ```
//! use raybook::shape::word;
//!
//! let lines: Vec<_> = word::lines("v 1 2 3\n\n  f 1 x\n").collect();
//! let wrong = lines[1][2].number().expect_err("a letter");
//! assert_eq!(wrong.to_string(), "3:7: expected a number, found `x`"); // line and column
//! ```

use crate::math::domain::LARGEST;
use crate::memory::{BUDGET, gigabytes};
use crate::shape::mesh::MeshError;
use glam::Vec3;

/// The form of a face's corner, for error messages.
pub const INDICES: &str = "indices, as in 3, 3/1, 3//2 or 3/1/2";

/// Maximum number of words after a line's first word. Further words are ignored, because words take many times the memory of
/// their text.
pub const MOST_WORDS: usize = 1 << 20;

/// A word of a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Word<'a> {
    /// The word itself, without white space.
    pub text: &'a str,
    /// The word's line, from 1.
    pub line: usize,
    /// The column where the word begins, in characters from 1.
    pub column: usize,
}

/// An error in a text, with its place.
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

/// The reason of an error in a mesh file.
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
    /// There are too few or too many numbers or words after a keyword.
    #[error("{what} needs {needs}, and here are {found}")]
    Count {
        /// What the line describes.
        what: &'static str,
        /// The number that is needed, as text.
        needs: &'static str,
        /// The number that was found.
        found: usize,
    },
    /// Another word is expected here.
    #[error("expected {expected}, found `{found}`")]
    Expected {
        /// What should stand here.
        expected: &'static str,
        /// What stands here.
        found: String,
    },
    /// An index, counted from 1 or back from −1, without an object.
    #[error("there is no {what} {index}: above this line are {given}, counted from 1")]
    Index {
        /// The kind of objects that are counted.
        what: &'static str,
        /// The index.
        index: i64,
        /// Number of objects that were read before.
        given: usize,
    },
    /// An index, counted from 0, without a vertex.
    #[error("there is no vertex {index}: the file has {given}, and the first is 0")]
    FromZero {
        /// The index, as in the file.
        index: String,
        /// Number of vertices.
        given: u64,
    },
    /// The faces and vertices take more memory, in bytes, than the budget allows.
    #[error("up to here the mesh takes {} of memory, and a mesh may take {}; make it coarser, or cut it up", gigabytes(*.0), gigabytes(BUDGET))]
    TooLarge(u64),
    /// The text ends too early.
    #[error("the file ends, but {0} is missing")]
    End(&'static str),
    /// What every file of the kind has is not there.
    #[error("there is no {0}")]
    Missing(&'static str),
}

impl Wrong {
    /// The error that the whole text does not make a mesh.
    pub(crate) fn as_mesh(error: MeshError) -> Self {
        Self {
            line: 1,
            column: 1,
            reason: Reason::Mesh(error),
        }
    }
}

impl Word<'_> {
    /// The error that this word is wrong, with the reason.
    pub fn wrong(&self, reason: Reason) -> Wrong {
        Wrong {
            line: self.line,
            column: self.column,
            reason,
        }
    }

    /// The error that something else is expected in place of this word.
    pub fn expected(&self, expected: &'static str) -> Wrong {
        self.wrong(Reason::Expected {
            expected,
            found: self.text.to_owned(),
        })
    }

    /// The word as a finite number.
    ///
    /// # Errors
    /// If the word is not a number, or is NaN or infinite: Rust also parses words such as `nan` and `inf`.
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

    /// A part of the word as an index, converted to count from 0. In the text, the `given` objects are counted from 1, or back
    /// from the last, −1.
    ///
    /// # Errors
    /// If it is not a whole number, or there is no such object.
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

/// The words of each line that has words, without comments, which begin with `#`; a line that ends with `\` is continued by the
/// next line.
pub fn lines(text: &str) -> impl Iterator<Item = Vec<Word<'_>>> {
    // Some editors begin a file with this byte order mark, which would become a part of the first word.
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

/// The words of one line, which has the line number `number`.
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

/// The name after a keyword: all following words, because a name may contain spaces.
pub fn name(words: &[Word]) -> String {
    let words: Vec<_> = words[1..].iter().map(|word| word.text).collect();
    words.join(" ")
}

/// The place of a vertex, in metres: the first three numbers after a keyword.
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

/// The finite numbers after a keyword; their number must be in `allowed`.
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
