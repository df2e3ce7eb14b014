//! Rows: questions and answers as numbers on a line, the same for every language.
//!
//! A row is words with spaces in between. A number is written as people write it, or `inf`, `-inf`, `nan`;
//! a missing value is `none`; a list begins with its length. Two spaces between fields are for the eye only.

/// Something that can be written as a row.
pub trait Row: Sized {
    /// Whether people are shown each one of a list on a line of its own.
    const ALONE: bool = false;

    /// The names of the words, in order, of a value of this name.
    fn names(name: &str) -> Vec<String>;

    /// The words.
    fn write(&self) -> String;

    /// The value in the next words; `name` is for the error.
    ///
    /// # Errors
    /// If a word is missing or is not what it should be.
    fn read(words: &mut Words<'_>, name: &str) -> Result<Self, RowError>;

    /// Each part with its name and its words, for people.
    fn parts(&self, name: &str) -> Vec<(String, String)> {
        vec![(name.to_owned(), self.write())]
    }
}

/// Reads a whole line as one value.
///
/// # Errors
/// If a word is missing, wrong, or left over.
pub fn read<R: Row>(line: &str, name: &str) -> Result<R, RowError> {
    let mut words = Words {
        rest: line.split_whitespace(),
        taken: 0,
    };
    let value = R::read(&mut words, name)?;
    match words.rest.next() {
        None => Ok(value),
        Some(found) => Err(RowError::TooLong {
            word: words.position(),
            found: found.to_owned(),
        }),
    }
}

/// The words of a line that are still to be read.
pub struct Words<'a> {
    rest: std::str::SplitWhitespace<'a>,
    taken: usize,
}

/// What is wrong with a row, and where.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum RowError {
    /// The line ends too early.
    #[error("the line ends before word {word}, `{name}`")]
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
        expected: &'static str,
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

impl<'a> Words<'a> {
    /// The number of the next word, from 1.
    pub fn position(&self) -> usize {
        self.taken + 1
    }

    /// The next word, parsed.
    ///
    /// # Errors
    /// If there is none, or `parse` refuses it; `name` and `expected` say what it should have been.
    pub fn next<T>(
        &mut self,
        name: &str,
        expected: &'static str,
        parse: impl Fn(&'a str) -> Option<T>,
    ) -> Result<T, RowError> {
        let word = self.position();
        let found = self.rest.next().ok_or_else(|| RowError::TooShort {
            word,
            name: name.to_owned(),
        })?;
        self.taken = word;
        parse(found).ok_or_else(|| RowError::Word {
            word,
            name: name.to_owned(),
            expected,
            found: found.to_owned(),
        })
    }

    /// Whether the next word is this one, in small or capital letters (Python prints `None`); then it is taken.
    pub fn take(&mut self, word: &str) -> bool {
        let mut ahead = self.rest.clone();
        let found = ahead
            .next()
            .is_some_and(|next| next.eq_ignore_ascii_case(word));
        if found {
            self.rest = ahead;
            self.taken += 1;
        }
        found
    }
}

/// Defines a struct of rows that is a row itself: its fields in order.
macro_rules! row {
    ($(#[$doc:meta])* pub struct $name:ident { $($(#[$field_doc:meta])* pub $field:ident: $kind:ty),+ $(,)? }) => {
        $(#[$doc])*
        #[derive(Clone, Debug, PartialEq)]
        pub struct $name {
            $($(#[$field_doc])* pub $field: $kind),+
        }

        crate::row::row_of!($name { $($field: $kind),+ });
    };
}

/// Makes a row of a struct that there is: its fields in order.
macro_rules! row_of {
    ($name:ty { $($field:ident: $kind:ty),+ $(,)? }) => {
        impl crate::row::Row for $name {
            fn names(_name: &str) -> Vec<String> {
                [$(<$kind as crate::row::Row>::names(stringify!($field))),+].concat()
            }

            fn write(&self) -> String {
                [$(<$kind as crate::row::Row>::write(&self.$field)),+].join("  ")
            }

            fn read(
                words: &mut crate::row::Words<'_>,
                _name: &str,
            ) -> Result<Self, crate::row::RowError> {
                Ok(Self { $($field: <$kind as crate::row::Row>::read(words, stringify!($field))?),+ })
            }

            fn parts(&self, _name: &str) -> Vec<(String, String)> {
                [$(<$kind as crate::row::Row>::parts(&self.$field, stringify!($field))),+].concat()
            }
        }
    };
}

pub(crate) use {row, row_of};
