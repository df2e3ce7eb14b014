//! Rows: questions and answers as numbers on a line, the same for every language.
//!
//! A row is words with spaces in between. A number is written as people write it, or `inf`, `-inf`, `nan`;
//! a missing value is `none`; a list begins with its length. Two spaces between fields are for the eye only.

use crate::image::rgb::Rgb;
use crate::math::{dir3::Dir3, interval::Interval, ray::Ray};
use glam::{Vec2, Vec3};

/// Something that can be written as a row.
pub trait Row: Sized {
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
            word: words.taken + 1,
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
    /// The next word, parsed.
    fn next<T>(
        &mut self,
        name: &str,
        expected: &'static str,
        parse: impl Fn(&'a str) -> Option<T>,
    ) -> Result<T, RowError> {
        let word = self.taken + 1;
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

    /// Whether the next word is this one; then it is taken.
    fn take(&mut self, word: &str) -> bool {
        let mut ahead = self.rest.clone();
        let found = ahead.next() == Some(word);
        if found {
            self.rest = ahead;
            self.taken += 1;
        }
        found
    }
}

/// One word, by `FromStr` and a format.
macro_rules! word_row {
    ($type:ty, $expected:literal, $write:expr) => {
        impl Row for $type {
            fn names(name: &str) -> Vec<String> {
                vec![name.to_owned()]
            }

            fn write(&self) -> String {
                $write(*self)
            }

            fn read(words: &mut Words<'_>, name: &str) -> Result<Self, RowError> {
                words.next(name, $expected, |word| word.parse().ok())
            }
        }
    };
}

word_row!(f32, "a number", |v: f32| format!("{v:?}")
    .trim_end_matches(".0")
    .to_lowercase());
word_row!(u32, "a whole number from 0 up", |v: u32| v.to_string());

/// Several values in a row, and how the whole is made of them.
macro_rules! several_row {
    ($type:ty, $($part:ident: $kind:ty = $get:expr),+ => $make:expr) => {
        impl Row for $type {
            fn names(name: &str) -> Vec<String> {
                [$(<$kind>::names(&format!("{name}.{}", stringify!($part)))),+].concat()
            }

            fn write(&self) -> String {
                [$(<$kind as Row>::write(&($get)(self))),+].join(" ")
            }

            fn read(words: &mut Words<'_>, name: &str) -> Result<Self, RowError> {
                $(let $part = <$kind>::read(words, &format!("{name}.{}", stringify!($part)))?;)+
                Ok($make)
            }
        }
    };
}

several_row!(Vec2, x: f32 = |v: &Vec2| v.x, y: f32 = |v: &Vec2| v.y => Vec2::new(x, y));
several_row!(Vec3, x: f32 = |v: &Vec3| v.x, y: f32 = |v: &Vec3| v.y, z: f32 = |v: &Vec3| v.z => Vec3::new(x, y, z));
several_row!(Rgb, r: f32 = |v: &Rgb| v.r, g: f32 = |v: &Rgb| v.g, b: f32 = |v: &Rgb| v.b => Rgb::new(r, g, b));
several_row!(Interval, min: f32 = |v: &Interval| v.min, max: f32 = |v: &Interval| v.max => Interval::new(min, max));

impl Row for Ray {
    fn names(_name: &str) -> Vec<String> {
        [Vec3::names("origin"), Dir3::names("direction")].concat()
    }

    fn write(&self) -> String {
        [self.origin.write(), self.direction.write()].join("  ")
    }

    fn read(words: &mut Words<'_>, _name: &str) -> Result<Self, RowError> {
        Ok(Self::new(
            Vec3::read(words, "origin")?,
            Dir3::read(words, "direction")?,
        ))
    }

    fn parts(&self, _name: &str) -> Vec<(String, String)> {
        [
            self.origin.parts("origin"),
            self.direction.parts("direction"),
        ]
        .concat()
    }
}

impl Row for Dir3 {
    fn names(name: &str) -> Vec<String> {
        Vec3::names(name)
    }

    fn write(&self) -> String {
        Vec3::write(self)
    }

    /// Any vector but zero; it is normalised unless it already is, to the last digit that matters.
    fn read(words: &mut Words<'_>, name: &str) -> Result<Self, RowError> {
        let word = words.taken + 1;
        let v = Vec3::read(words, name)?;
        Dir3::new(v).ok_or_else(|| RowError::Word {
            word,
            name: name.to_owned(),
            expected: "a direction",
            found: v.write(),
        })
    }
}

impl<T: Row> Row for Option<T> {
    fn names(name: &str) -> Vec<String> {
        let names = T::names(name);
        vec![format!("none | {}", names.join(" "))]
    }

    fn write(&self) -> String {
        self.as_ref().map_or_else(|| "none".to_owned(), Row::write)
    }

    fn read(words: &mut Words<'_>, name: &str) -> Result<Self, RowError> {
        if words.take("none") {
            Ok(None)
        } else {
            T::read(words, name).map(Some)
        }
    }

    fn parts(&self, name: &str) -> Vec<(String, String)> {
        self.as_ref().map_or_else(
            || vec![(name.to_owned(), "none".to_owned())],
            |value| value.parts(name),
        )
    }
}

impl<T: Row> Row for Vec<T> {
    fn names(name: &str) -> Vec<String> {
        vec![
            format!("{name}.count"),
            format!("[{}]…", T::names(name).join(" ")),
        ]
    }

    fn write(&self) -> String {
        std::iter::once(self.len().to_string())
            .chain(self.iter().map(Row::write))
            .collect::<Vec<_>>()
            .join("  ")
    }

    fn read(words: &mut Words<'_>, name: &str) -> Result<Self, RowError> {
        let count = u32::read(words, &format!("the number of {name}"))?;
        (0..count)
            .map(|i| T::read(words, &format!("{name}[{i}]")))
            .collect()
    }
}

/// Defines a struct of rows that is a row itself: its fields in order.
#[macro_export]
macro_rules! row {
    ($(#[$doc:meta])* pub struct $name:ident { $($(#[$field_doc:meta])* pub $field:ident: $kind:ty),+ $(,)? }) => {
        $(#[$doc])*
        #[derive(Clone, Debug, PartialEq)]
        pub struct $name {
            $($(#[$field_doc])* pub $field: $kind),+
        }

        impl $crate::workbook::row::Row for $name {
            fn names(_name: &str) -> Vec<String> {
                [$(<$kind as $crate::workbook::row::Row>::names(stringify!($field))),+].concat()
            }

            fn write(&self) -> String {
                [$(<$kind as $crate::workbook::row::Row>::write(&self.$field)),+].join("  ")
            }

            fn read(
                words: &mut $crate::workbook::row::Words<'_>,
                _name: &str,
            ) -> Result<Self, $crate::workbook::row::RowError> {
                Ok(Self { $($field: <$kind as $crate::workbook::row::Row>::read(words, stringify!($field))?),+ })
            }

            fn parts(&self, _name: &str) -> Vec<(String, String)> {
                [$(<$kind as $crate::workbook::row::Row>::parts(&self.$field, stringify!($field))),+].concat()
            }
        }
    };
}
