//! The words of a row, and what may be wrong with them.

use std::fmt::Display;
use std::str::FromStr;

/// The words of a line that are still to be read.
pub(crate) struct Words<'a> {
    rest: &'a str,
    taken: usize,
}

/// What is wrong with a row, and where.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum RowError {
    /// The line ends too early.
    #[error("word {word}, `{name}`, is missing")]
    TooShort {
        /// Which word is missing, from 1.
        word: usize,
        /// What it should have been.
        name: String,
    },
    /// Not a number, or not the right kind.
    #[error("word {word} should be `{name}`, {expected}, but is `{found}`")]
    Word {
        /// Which word, from 1.
        word: usize,
        /// What it should have been.
        name: String,
        /// "a number", say.
        expected: String,
        /// What it is.
        found: String,
    },
    /// Words are left over.
    #[error("word {word}, `{found}`, is one too many")]
    TooLong {
        /// Which word, from 1.
        word: usize,
        /// What it is.
        found: String,
    },
}

impl RowError {
    /// Which word is wrong or missing, from 1.
    pub fn place(&self) -> usize {
        match self {
            Self::TooShort { word, .. } | Self::Word { word, .. } | Self::TooLong { word, .. } => {
                *word
            }
        }
    }

    /// A wrong word.
    pub(crate) fn word(word: usize, name: &dyn Display, expected: &str, found: &str) -> Self {
        Self::Word {
            word,
            name: name.to_string(),
            expected: expected.to_owned(),
            found: found.to_owned(),
        }
    }
}

impl<'a> Words<'a> {
    /// The words of a line.
    pub(crate) fn of(line: &'a str) -> Self {
        Self {
            rest: line,
            taken: 0,
        }
    }

    /// The next word, and what follows it.
    fn next(&self) -> Option<(&'a str, &'a str)> {
        let rest = self.rest.trim_start();
        let mut bytes = rest.bytes();
        // Nearly all words are ASCII, whose bytes are letters.
        let end = match bytes.position(|byte| byte.is_ascii_whitespace() || !byte.is_ascii()) {
            Some(end) if rest.is_char_boundary(end + 1) => Some(end),
            Some(_) => rest.find(char::is_whitespace),
            None => None,
        };
        let end = end.unwrap_or(rest.len());
        let (word, rest) = rest.split_at(end);
        (!word.is_empty()).then_some((word, rest))
    }

    /// Takes a word: the line goes on with what follows it.
    fn go_on(&mut self, rest: &'a str) {
        self.rest = rest;
        self.taken += 1;
    }

    /// The number of the next word, from 1.
    pub(crate) fn position(&self) -> usize {
        self.taken + 1
    }

    /// The next word as a number.
    pub(crate) fn number(&mut self, name: &dyn Display) -> Result<f64, RowError> {
        self.parsed::<f32>(name, "a number").map(f64::from)
    }

    /// The next word as a whole number.
    pub(crate) fn whole(&mut self, name: &dyn Display) -> Result<u32, RowError> {
        self.parsed(name, "a whole number from 0 up")
    }

    fn parsed<T: FromStr>(&mut self, name: &dyn Display, expected: &str) -> Result<T, RowError> {
        let parsed = self
            .next()
            .and_then(|(word, rest)| Some((word.parse().ok()?, rest)));
        let (value, rest) = parsed.ok_or_else(|| self.refuse(name, expected))?;
        self.go_on(rest);
        Ok(value)
    }

    /// Why the next word cannot be read.
    pub(crate) fn refuse(&self, name: &dyn Display, expected: &str) -> RowError {
        let word = self.position();
        match self.next() {
            Some((found, _)) => RowError::word(word, name, expected, found),
            None => RowError::TooShort {
                word,
                name: name.to_string(),
            },
        }
    }

    /// Whether the next word is this one, in small or capital letters (Python prints `None`); then it is taken.
    pub(crate) fn take(&mut self, word: &str) -> bool {
        let found = self
            .next()
            .filter(|(next, _)| next.eq_ignore_ascii_case(word));
        if let Some((_, rest)) = found {
            self.go_on(rest);
        }
        found.is_some()
    }

    /// The end of the line.
    ///
    /// # Errors
    /// If a word is left over.
    pub(crate) fn end(&self) -> Result<(), RowError> {
        match self.next() {
            None => Ok(()),
            Some((found, _)) => Err(RowError::TooLong {
                word: self.position(),
                found: found.to_owned(),
            }),
        }
    }
}
