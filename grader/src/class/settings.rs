//! Reading a file of settings in TOML. Every error says the file, the line and the column, what was expected, and which name
//! was probably meant.

use super::when::Timestamp;
use raybook_chapters::kit::untrusted::Untrusted;
use std::cell::RefCell;
use std::fmt::Display;
use std::ops::{Range, RangeInclusive};
use std::path::Path;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// What is wrong in a file of settings, and where.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{file}:{line}:{column}: {what}")]
pub struct SettingsError {
    /// The file, ready to be shown.
    pub file: String,
    /// The line, from 1.
    pub line: usize,
    /// The column, in characters from 1.
    pub column: usize,
    /// What is wrong, and what was expected.
    pub what: String,
}

/// The text of a file of settings.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    /// The file, for errors.
    pub file: &'a Path,
    /// Its text.
    pub text: &'a str,
}

impl Source<'_> {
    /// The error at a place in the text.
    pub fn error(&self, at: &Range<usize>, what: impl Display) -> SettingsError {
        let before = self.text.get(..at.start).unwrap_or(self.text);
        let line = before.rsplit('\n').next().unwrap_or_default();
        SettingsError {
            file: Untrusted::from(self.file).to_string(),
            line: before.matches('\n').count() + 1,
            column: line.chars().count() + 1,
            what: what.to_string(),
        }
    }

    /// The tables of the text.
    ///
    /// # Errors
    /// If it is no TOML.
    pub fn parse(&self) -> Result<Spanned<DeTable<'_>>, SettingsError> {
        DeTable::parse(self.text).map_err(|error| {
            let at = error.span().unwrap_or_default();
            self.error(&at, Untrusted::from(error.message()))
        })
    }
}

/// A value and its place in the text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Placed<T> {
    /// The value.
    pub value: T,
    /// Its place, in bytes.
    pub at: Range<usize>,
}

/// Names with a number each.
pub type Numbered<'a> = Vec<(Placed<&'a str>, f64)>;

/// A table of settings. Names are asked for one by one; [`Table::finish`] tells of those that nobody asked for.
pub struct Table<'a> {
    source: Source<'a>,
    entries: &'a DeTable<'a>,
    asked: RefCell<Vec<&'static str>>,
}

impl<'a> Table<'a> {
    /// A table of a text.
    pub fn new(source: Source<'a>, table: &'a DeTable<'a>) -> Self {
        Self {
            source,
            entries: table,
            asked: RefCell::default(),
        }
    }

    fn find(&self, name: &'static str) -> Option<&'a Spanned<DeValue<'a>>> {
        self.asked.borrow_mut().push(name);
        let mut entries = self.entries.iter();
        entries.find_map(|(key, value)| (key.get_ref() == name).then_some(value))
    }

    /// A value of one kind; `None` where the name is not there.
    fn read<T>(
        &self,
        name: &'static str,
        expected: &str,
        read: impl Fn(&'a DeValue<'a>) -> Option<T>,
    ) -> Result<Option<Placed<T>>, SettingsError> {
        let Some(found) = self.find(name) else {
            return Ok(None);
        };
        let at = found.span();
        match read(found.get_ref()) {
            Some(value) => Ok(Some(Placed { value, at })),
            None => Err(self
                .source
                .error(&at, format!("`{name}` must be {expected}"))),
        }
    }

    /// A text.
    ///
    /// # Errors
    /// If it is none.
    pub fn text(&self, name: &'static str) -> Result<Option<Placed<&'a str>>, SettingsError> {
        self.read(name, "a text in quotes", DeValue::as_str)
    }

    /// A number in a range.
    ///
    /// # Errors
    /// If it is none, or not in the range.
    pub fn number(
        &self,
        name: &'static str,
        range: RangeInclusive<f64>,
    ) -> Result<Option<f64>, SettingsError> {
        let expected = format!("a number from {} to {}", range.start(), range.end());
        let within = |value| number(value).filter(|number| range.contains(number));
        Ok(self
            .read(name, &expected, within)?
            .map(|placed| placed.value))
    }

    /// Yes or no.
    ///
    /// # Errors
    /// If it is neither.
    pub fn yes(&self, name: &'static str) -> Result<Option<bool>, SettingsError> {
        let read = self.read(name, "true or false", DeValue::as_bool)?;
        Ok(read.map(|placed| placed.value))
    }

    /// A date and a time of day with its offset from UTC.
    ///
    /// # Errors
    /// If it is none.
    pub fn instant(&self, name: &'static str) -> Result<Option<Timestamp>, SettingsError> {
        let expected =
            "a date and a time with an offset from UTC, such as 2026-11-30T23:59:00+01:00";
        let read = |value: &DeValue<'_>| Timestamp::of(value.as_datetime()?);
        Ok(self.read(name, expected, read)?.map(|placed| placed.value))
    }

    /// A list of texts.
    ///
    /// # Errors
    /// If it is none.
    pub fn words(&self, name: &'static str) -> Result<Option<Vec<Placed<&'a str>>>, SettingsError> {
        let read = self.read(name, "a list of texts, such as [\"a\", \"b\"]", words)?;
        Ok(read.map(|placed| placed.value))
    }

    /// Names with a number each: a table of numbers; or a list of names, each with the number `otherwise`.
    ///
    /// # Errors
    /// If it is neither, or a number is not in the range.
    pub fn numbered(
        &self,
        name: &'static str,
        otherwise: f64,
        range: &RangeInclusive<f64>,
    ) -> Result<Option<Numbered<'a>>, SettingsError> {
        let Some(found) = self.find(name) else {
            return Ok(None);
        };
        if let Some(names) = words(found.get_ref()) {
            return Ok(Some(
                names.into_iter().map(|name| (name, otherwise)).collect(),
            ));
        }
        let Some(table) = found.get_ref().as_table() else {
            let expected = format!(
                "`{name}` must be a list of names, such as [\"a\", \"b\"], or a table of numbers, such as {{ a = 1, b = 2 }}"
            );
            return Err(self.source.error(&found.span(), expected));
        };
        let mut numbers = Vec::new();
        for (key, value) in table {
            let Some(number) = number(value.get_ref()).filter(|number| range.contains(number))
            else {
                let expected = format!(
                    "`{}` must be a number from {} to {}",
                    Untrusted::from(key.get_ref().as_ref()),
                    range.start(),
                    range.end()
                );
                return Err(self.source.error(&value.span(), expected));
            };
            let name = Placed {
                value: key.get_ref().as_ref(),
                at: key.span(),
            };
            numbers.push((name, number));
        }
        numbers.sort_by_key(|(name, _)| name.at.start);
        Ok(Some(numbers))
    }

    /// A table within this one.
    ///
    /// # Errors
    /// If it is none.
    pub fn table(&self, name: &'static str) -> Result<Option<Table<'a>>, SettingsError> {
        let expected = format!("a table, which begins with [{name}]");
        let read = self.read(name, &expected, DeValue::as_table)?;
        Ok(read.map(|placed| Table::new(self.source, placed.value)))
    }

    /// The tables of a list, each with its place.
    ///
    /// # Errors
    /// If it is no list of tables.
    pub fn tables(&self, name: &'static str) -> Result<Vec<Placed<Table<'a>>>, SettingsError> {
        let expected = format!("a list of tables, each of which begins with [[{name}]]");
        let read = self.read(name, &expected, |value| {
            let of = |value: &'a Spanned<DeValue<'a>>| {
                Some(Placed {
                    value: Table::new(self.source, value.get_ref().as_table()?),
                    at: value.span(),
                })
            };
            value.as_array()?.iter().map(of).collect::<Option<Vec<_>>>()
        })?;
        Ok(read.map_or_else(Vec::new, |placed| placed.value))
    }

    /// Nothing else may stand in the table: a name that nobody asked for is a mistake in writing.
    ///
    /// # Errors
    /// The first such name, and the one that was probably meant.
    pub fn finish(&self) -> Result<(), SettingsError> {
        let asked = self.asked.borrow();
        let unknown = self
            .entries
            .keys()
            .filter(|key| !asked.contains(&key.get_ref().as_ref()));
        let Some(key) = unknown.min_by_key(|key| key.span().start) else {
            return Ok(());
        };
        let what = unknown_name("name", key.get_ref(), asked.iter().copied());
        Err(self.source.error(&key.span(), what))
    }
}

/// What is said of a name that does not exist: the one that was probably meant, or all that there are.
pub fn unknown_name<'a>(
    what: &str,
    name: &str,
    names: impl Iterator<Item = &'a str> + Clone,
) -> String {
    /// As much of a word may be wrong as makes it this alike.
    const ALIKE: f64 = 0.6;
    let alike = |known: &&str| strsim::normalized_damerau_levenshtein(known, name);
    let nearest = names.clone().max_by(|a, b| alike(a).total_cmp(&alike(b)));
    let name = Untrusted::from(name);
    if let Some(nearest) = nearest.filter(|nearest| alike(nearest) >= ALIKE) {
        return format!("there is no {what} `{name}` here; did you mean `{nearest}`?");
    }
    let names: Vec<_> = names.collect();
    format!(
        "there is no {what} `{name}` here; there are {}",
        names.join(", ")
    )
}

/// A number that is finite, whole or not.
fn number(value: &DeValue<'_>) -> Option<f64> {
    let text = match value {
        DeValue::Integer(whole) if whole.radix() == 10 => whole.as_str(),
        DeValue::Float(number) => number.as_str(),
        _ => return None,
    };
    text.parse().ok().filter(|number: &f64| number.is_finite())
}

fn words<'a>(value: &'a DeValue<'a>) -> Option<Vec<Placed<&'a str>>> {
    let of = |word: &'a Spanned<DeValue<'a>>| {
        Some(Placed {
            value: word.get_ref().as_str()?,
            at: word.span(),
        })
    };
    value.as_array()?.iter().map(of).collect()
}
