//! A table of a file that people write in TOML, a scene or a course: every field that is read is checked, and a field that nobody
//! reads is an error.
//!
//! ```
//! use raybook_scenes::{fields::Fields, wrong::Source};
//!
//! let source = Source { path: "ball.toml".as_ref(), text: "radius_m = 2\ncolour = 0.5" };
//! let table = source.parse()?;
//! let ball = Fields::new(source, "a ball", 0, table.get_ref());
//! assert_eq!(ball.length("radius_m")?, Some(2.0));
//! let error = ball.finish().expect_err("nobody has read the colour");
//! assert_eq!(error.to_string(), "ball.toml:2:1: a ball has no field `colour`; it has `radius_m`");
//! # Ok::<(), raybook_scenes::wrong::TextError>(())
//! ```

use crate::values::{colour, described, number, place, three, whole};
use crate::wrong::{Source, TextError, did_you_mean, listed, shown};
use glam::Vec3;
use raybook::image::{Image, file, rgb::Rgb};
use raybook::math::{dir3::Dir3, domain::LARGEST};
use std::borrow::Cow;
use std::cell::RefCell;
use std::ops::RangeInclusive;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// The brightest light that a scene may have.
const BRIGHTEST: f32 = 1e12;

/// PNG files that are part of the program, with the names by which a text refers to them.
pub type Pictures = &'static [(&'static str, &'static [u8])];

/// Makes something of a table of its kind.
pub type Make<T> = fn(&Fields) -> Result<T, TextError>;

/// A table, and the names of the fields that were read.
#[derive(Debug)]
pub struct Fields<'a> {
    source: Source<'a>,
    /// What it describes: "the camera", "a sphere".
    what: String,
    start: usize,
    table: &'a DeTable<'a>,
    asked: RefCell<Vec<&'static str>>,
    pictures: Pictures,
}

impl<'a> Fields<'a> {
    /// A table of the text that begins at a byte of it, and what it describes.
    pub fn new(source: Source<'a>, what: &str, start: usize, table: &'a DeTable<'a>) -> Self {
        Self {
            source,
            what: what.to_owned(),
            start,
            table,
            asked: RefCell::default(),
            pictures: &[],
        }
    }

    /// The same, and the tables in this one, with pictures that need no files.
    #[must_use]
    pub fn with_pictures(self, pictures: Pictures) -> Self {
        Self { pictures, ..self }
    }

    /// The text.
    pub fn source(&self) -> Source<'a> {
        self.source
    }

    /// The byte of the text at which the table begins.
    pub fn start(&self) -> usize {
        self.start
    }

    /// The value of a field.
    pub fn value(&self, key: &'static str) -> Option<&'a Spanned<DeValue<'a>>> {
        self.asked.borrow_mut().push(key);
        let mut all = self.table.iter();
        all.find(|(name, _)| name.get_ref() == key)
            .map(|(_, value)| value)
    }

    /// The names of all fields, with their values, where names are free.
    pub fn all(&self) -> impl Iterator<Item = (&'a str, &'a Spanned<DeValue<'a>>)> + use<'a> {
        self.table
            .iter()
            .map(|(name, value)| (&**name.get_ref(), value))
    }

    /// What is wrong with a field.
    pub fn wrong(&self, key: &str, message: impl Into<String>) -> TextError {
        let mut all = self.table.iter();
        let value = all.find(|(name, _)| name.get_ref() == key);
        let at = value.map_or(self.start, |(_, value)| value.span().start);
        self.source.wrong(at, message)
    }

    /// What `read` finds in a field that must be there.
    ///
    /// # Errors
    /// Those of `read`, and if the field is missing.
    pub fn need<T>(
        &self,
        key: &'static str,
        read: impl Fn(&Self, &'static str) -> Result<Option<T>, TextError>,
    ) -> Result<T, TextError> {
        read(self, key)?.ok_or_else(|| {
            let needs = format!("{} needs {}", self.what, shown(key));
            let is_near = |name: &str| !did_you_mean(name, [key]).is_empty();
            self.unread(is_near).map_or_else(
                || self.source.wrong(self.start, &needs),
                |name| {
                    let message = format!("{needs}: is it meant by {}?", shown(name.get_ref()));
                    self.source.wrong(name.span().start, message)
                },
            )
        })
    }

    /// The first of the fields that nobody has read and that are called so.
    fn unread(&self, is_so: impl Fn(&str) -> bool) -> Option<&'a Spanned<Cow<'a, str>>> {
        let asked = self.asked.borrow();
        let names = self.table.iter().map(|(name, _)| name);
        let unread = names.filter(|name| {
            let name = &**name.get_ref();
            !asked.contains(&name) && is_so(name)
        });
        unread.min_by_key(|name| name.span().start)
    }

    /// A length in metres, above 0.
    ///
    /// # Errors
    /// If there is something else.
    pub fn length(&self, key: &'static str) -> Result<Option<f32>, TextError> {
        self.number(key, 1e-9..=LARGEST)
    }

    /// A value that is read by a function; where that returns `None`, the error says what was expected.
    ///
    /// # Errors
    /// If there is something else.
    pub fn get<T>(
        &self,
        key: &'static str,
        expected: &str,
        read: impl Fn(&'a DeValue<'a>) -> Option<T>,
    ) -> Result<Option<T>, TextError> {
        let Some(value) = self.value(key) else {
            return Ok(None);
        };
        let read = read(value.get_ref()).ok_or_else(|| {
            let found = described(value.get_ref());
            let message = format!("{} must be {expected}, and this is {found}", shown(key));
            self.source.wrong(value.span().start, message)
        });
        read.map(Some)
    }

    /// A number in a range.
    ///
    /// # Errors
    /// If there is something else.
    pub fn number(
        &self,
        key: &'static str,
        within: RangeInclusive<f32>,
    ) -> Result<Option<f32>, TextError> {
        let expected = format!("a number from {} to {}", within.start(), within.end());
        self.get(key, &expected, |value| {
            number(value)
                .map(|v| v as f32)
                .filter(|v| within.contains(v))
        })
    }

    /// As [`Fields::number`], in twice the precision.
    ///
    /// # Errors
    /// If there is something else.
    pub fn precise(
        &self,
        key: &'static str,
        within: &RangeInclusive<f64>,
    ) -> Result<Option<f64>, TextError> {
        let expected = format!("a number from {} to {}", within.start(), within.end());
        self.get(key, &expected, |value| {
            number(value).filter(|v| within.contains(v))
        })
    }

    /// A whole number in a range.
    ///
    /// # Errors
    /// If there is something else.
    pub fn whole(
        &self,
        key: &'static str,
        within: RangeInclusive<u64>,
    ) -> Result<Option<u64>, TextError> {
        let expected = format!("a whole number from {} to {}", within.start(), within.end());
        let read = |value: &DeValue| whole(value)?.try_into().ok().filter(|v| within.contains(v));
        self.get(key, &expected, read)
    }

    /// A place or an edge: three coordinates in metres.
    ///
    /// # Errors
    /// If there is something else, or it is outside the domain.
    pub fn place(&self, key: &'static str) -> Result<Option<Vec3>, TextError> {
        let expected = format!("three numbers, [x, y, z], from -{LARGEST:e} to {LARGEST:e}");
        self.get(key, &expected, place)
    }

    /// A list of places.
    ///
    /// # Errors
    /// If there is something else, or one is outside the domain.
    pub fn places(&self, key: &'static str) -> Result<Option<Vec<Vec3>>, TextError> {
        let expected =
            format!("a list of places, [[x, y, z], …], from -{LARGEST:e} to {LARGEST:e}");
        self.get(key, &expected, |value| {
            let list = value.as_array()?;
            list.iter().map(|value| place(value.get_ref())).collect()
        })
    }

    /// A direction of any length.
    ///
    /// # Errors
    /// If there is something else, or it is zero.
    pub fn direction(&self, key: &'static str) -> Result<Option<Dir3>, TextError> {
        let expected = "three numbers, [x, y, z], that are not all 0";
        self.get(key, expected, |value| Dir3::new(three(value)?))
    }

    /// A share of the light, in each channel from 0 to 1.
    ///
    /// # Errors
    /// If there is something else.
    pub fn share(&self, key: &'static str) -> Result<Option<Rgb>, TextError> {
        self.get(
            key,
            "a number from 0 to 1, or three, [red, green, blue]",
            |value| colour(value, 1.0),
        )
    }

    /// Light, in each channel from 0.
    ///
    /// # Errors
    /// If there is something else.
    pub fn light(&self, key: &'static str) -> Result<Option<Rgb>, TextError> {
        let expected = format!("a number from 0 to {BRIGHTEST:e}, or three, [red, green, blue]");
        self.get(key, &expected, |value| colour(value, BRIGHTEST))
    }

    /// Yes or no.
    ///
    /// # Errors
    /// If there is something else.
    pub fn yes(&self, key: &'static str) -> Result<Option<bool>, TextError> {
        self.get(key, "true or false", DeValue::as_bool)
    }

    /// A text.
    ///
    /// # Errors
    /// If there is something else.
    pub fn text(&self, key: &'static str) -> Result<Option<&'a str>, TextError> {
        self.get(key, "a text in quotes", DeValue::as_str)
    }

    /// The picture of this name, which the field has: one that is part of the program, or else a file beside the text.
    ///
    /// # Errors
    /// If it cannot be read.
    pub fn picture(&self, key: &str, name: &str) -> Result<Image, TextError> {
        let picture = match self.pictures.iter().find(|(known, _)| *known == name) {
            Some((_, bytes)) => file::from_png(bytes),
            None => file::load(&self.source.beside(name)).map_err(|error| error.to_string()),
        };
        picture.map_err(|error| self.wrong(key, error))
    }

    /// What the word stands for, of those that are known.
    ///
    /// # Errors
    /// If there is something else.
    pub fn choice<T: Clone>(
        &self,
        key: &'static str,
        known: &[(&'static str, T)],
    ) -> Result<Option<T>, TextError> {
        let Some(text) = self.text(key)? else {
            return Ok(None);
        };
        let found = known.iter().find(|(word, _)| *word == text);
        found.map(|(_, value)| Some(value.clone())).ok_or_else(|| {
            let words = || known.iter().map(|(word, _)| *word);
            let hint = did_you_mean(text, words());
            let message = format!("{} is none of {}{hint}", shown(text), listed(words()));
            self.wrong(key, message)
        })
    }

    /// What the field `kind` stands for, which must be there. From now on the table is described as `what` of this kind.
    ///
    /// # Errors
    /// If there is something else, or nothing.
    pub fn kind<T: Clone>(
        &mut self,
        what: &str,
        known: &[(&'static str, T)],
    ) -> Result<T, TextError> {
        let chosen = self.need("kind", |fields, key| fields.choice(key, known))?;
        let word = self.text("kind")?.unwrap_or_default();
        self.what = format!("{what} of the kind `{word}`");
        Ok(chosen)
    }

    /// What the table makes, by the function of its kind.
    ///
    /// # Errors
    /// Those of [`Fields::kind`], of the function, and of [`Fields::finish`].
    pub fn made<T>(
        mut self,
        what: &str,
        kinds: &[(&'static str, Make<T>)],
    ) -> Result<T, TextError> {
        let made = self.kind(what, kinds)?(&self)?;
        self.finish()?;
        Ok(made)
    }

    /// A table in this one.
    ///
    /// # Errors
    /// If there is something else.
    pub fn table(&self, key: &'static str, what: &str) -> Result<Option<Self>, TextError> {
        self.value(key)
            .map(|value| self.of(value, key, what))
            .transpose()
    }

    /// A list of tables in this one.
    ///
    /// # Errors
    /// If there is something else.
    pub fn tables(&self, key: &'static str, what: &str) -> Result<Vec<Self>, TextError> {
        let Some(value) = self.value(key) else {
            return Ok(Vec::new());
        };
        let Some(list) = value.get_ref().as_array() else {
            let message = format!(
                "{what} begins with [[{key}]]: {} must be a list of tables",
                shown(key)
            );
            return Err(self.source.wrong(value.span().start, message));
        };
        list.iter().map(|value| self.of(value, key, what)).collect()
    }

    /// A value as a table.
    ///
    /// # Errors
    /// If there is something else.
    pub fn of(
        &self,
        value: &'a Spanned<DeValue<'a>>,
        key: &str,
        what: &str,
    ) -> Result<Self, TextError> {
        let start = value.span().start;
        let Some(table) = value.get_ref().as_table() else {
            let found = described(value.get_ref());
            let message = format!("{} must be a table, and this is {found}", shown(key));
            return Err(self.source.wrong(start, message));
        };
        Ok(Self::new(self.source, what, start, table).with_pictures(self.pictures))
    }

    /// The end: every field was read.
    ///
    /// # Errors
    /// The first field that was not read.
    pub fn finish(self) -> Result<(), TextError> {
        let Some(first) = self.unread(|_| true) else {
            return Ok(());
        };
        let asked = self.asked.borrow();
        let name = &**first.get_ref();
        let hint = did_you_mean(name, asked.iter().copied());
        let hint = if hint.is_empty() {
            format!("; it has {}", listed(asked.iter().copied()))
        } else {
            hint
        };
        let message = format!("{} has no field {}{hint}", self.what, shown(name));
        Err(self.source.wrong(first.span().start, message))
    }
}
