//! What settings have that scenes have not: instants, words with their places, names with a number each.

use super::when::Timestamp;
use raybook_scenes::fields::Fields;
use raybook_scenes::values::number;
use raybook_scenes::wrong::{TextError, shown};
use std::ops::RangeInclusive;
use toml::de::DeValue;

/// A word of the text, and the byte at which it stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Word<'a> {
    /// The word.
    pub text: &'a str,
    /// Its place, in bytes.
    pub at: usize,
}

/// Names with a number each.
pub type Numbered<'a> = Vec<(Word<'a>, f64)>;

/// A date and a time of day with its offset from UTC.
///
/// # Errors
/// If there is something else.
pub fn instant(fields: &Fields<'_>, key: &'static str) -> Result<Option<Timestamp>, TextError> {
    let expected = "a date and a time with an offset from UTC, such as 2026-11-30T23:59:00+01:00";
    fields.get(key, expected, |value| Timestamp::of(value.as_datetime()?))
}

/// A list of texts.
///
/// # Errors
/// If there is something else.
pub fn words<'a>(
    fields: &Fields<'a>,
    key: &'static str,
) -> Result<Option<Vec<Word<'a>>>, TextError> {
    fields.get(key, "a list of texts, such as [\"a\", \"b\"]", list)
}

/// Names with a number each: a table of numbers; or a list of names, each with the number `otherwise`.
///
/// # Errors
/// If there is something else, or a number is not in the range.
pub fn numbered<'a>(
    fields: &Fields<'a>,
    key: &'static str,
    otherwise: f64,
    within: &RangeInclusive<f64>,
) -> Result<Option<Numbered<'a>>, TextError> {
    let Some(found) = fields.value(key) else {
        return Ok(None);
    };
    if let Some(names) = list(found.get_ref()) {
        let names = names.into_iter().map(|name| (name, otherwise));
        return Ok(Some(names.collect()));
    }
    let Some(table) = found.get_ref().as_table() else {
        let expected = "a list of names, such as [\"a\", \"b\"], or a table of numbers, such as { a = 1, b = 2 }";
        return Err(fields.wrong(key, format!("{} must be {expected}", shown(key))));
    };
    let mut numbers = Vec::new();
    for (name, value) in table {
        let (at, text) = (name.span().start, name.get_ref().as_ref());
        let Some(number) = number(value.get_ref()).filter(|number| within.contains(number)) else {
            let (least, most) = (within.start(), within.end());
            let expected = format!("{} must be a number from {least} to {most}", shown(text));
            return Err(fields.source().wrong(value.span().start, expected));
        };
        numbers.push((Word { text, at }, number));
    }
    numbers.sort_by_key(|(name, _)| name.at);
    Ok(Some(numbers))
}

fn list<'a>(value: &'a DeValue<'a>) -> Option<Vec<Word<'a>>> {
    let words = value.as_array()?.iter().map(|value| {
        Some(Word {
            text: value.get_ref().as_str()?,
            at: value.span().start,
        })
    });
    words.collect()
}
