//! Rows: questions and answers as words on a line, the same for every language.
//!
//! A row is words with spaces in between. A number is written as people write it, or `inf`, `-inf`, `nan`;
//! a missing value is `none`; a list begins with its length. Two spaces between fields are for the eye only.
//!
//! In between, a row is a list of numbers: an `f64` holds every `f32` and every `u32`, `none` is 0 and a value that is there
//! is 1 and itself, a choice is its place among the choices. Between words and numbers goes the [`Kind`], here, once for all
//! types; between numbers and a type goes its [`Row`], which cannot fail.

use crate::kind::{Kind, VECTOR};
use crate::words::Words;
use glam::Vec3;
use raybook::math::dir3::Dir3;
use std::fmt::{Display, Write};

pub use crate::words::RowError;

/// Something that can be written as a row.
pub trait Row: Sized {
    /// What it is made of.
    const KIND: &'static Kind;

    /// Appends its numbers.
    fn put(&self, numbers: &mut Vec<f64>);

    /// The value in the next numbers, which are of its kind.
    fn take(numbers: &mut Numbers<'_>) -> Self;

    /// Its words.
    fn write(&self) -> String {
        format(Self::KIND, &to_numbers(self))
    }
}

/// The numbers of a row that are still to be taken.
#[derive(Debug)]
pub struct Numbers<'a>(std::slice::Iter<'a, f64>);

impl<'a> Numbers<'a> {
    /// The numbers of a row, from the first.
    pub fn of(numbers: &'a [f64]) -> Self {
        Self(numbers.iter())
    }

    /// The next number; 0 after the last.
    pub fn number(&mut self) -> f64 {
        self.0.next().copied().unwrap_or(0.0)
    }
}

/// The value of a row's numbers.
pub fn from_numbers<R: Row>(numbers: &[f64]) -> R {
    R::take(&mut Numbers::of(numbers))
}

/// The numbers of a value.
pub fn to_numbers<R: Row>(value: &R) -> Vec<f64> {
    let mut numbers = Vec::new();
    value.put(&mut numbers);
    numbers
}

/// A value as a line; `name` is for the error.
///
/// # Errors
/// If a word is missing, wrong, or left over.
pub fn read<R: Row>(line: &str, name: &str) -> Result<R, RowError> {
    Ok(from_numbers(&parse(R::KIND, line, name)?))
}

/// The numbers of a whole line; `name` is for the error.
///
/// # Errors
/// If a word is missing, wrong, or left over.
pub fn parse(kind: &Kind, line: &str, name: &str) -> Result<Vec<f64>, RowError> {
    let mut words = Words::of(line);
    let mut numbers = Vec::new();
    parse_next(kind, &mut words, &name, &mut numbers)?;
    words.end()?;
    Ok(numbers)
}

/// The line of a row's numbers.
pub fn format(kind: &Kind, numbers: &[f64]) -> String {
    let mut line = String::new();
    format_next(kind, &mut Numbers::of(numbers), &mut line);
    line
}

/// Each part of a row with its name and its words, for people.
pub fn parts(kind: &Kind, name: &str, numbers: &[f64]) -> Vec<(String, String)> {
    let mut parts = Vec::new();
    parts_next(kind, name, &mut Numbers::of(numbers), &mut parts);
    parts
}

fn parse_next(
    kind: &Kind,
    words: &mut Words<'_>,
    name: &dyn Display,
    numbers: &mut Vec<f64>,
) -> Result<(), RowError> {
    match kind {
        Kind::Number => numbers.push(words.number(name)?),
        Kind::Whole => numbers.push(words.whole(name)?.into()),
        Kind::Numbers(parts) => {
            for part in parts.parts {
                numbers.push(words.number(&format_args!("{name}.{part}"))?);
            }
        }
        Kind::Direction => {
            let at = words.position();
            parse_next(&Kind::Numbers(VECTOR), words, name, numbers)?;
            let last = &numbers[numbers.len() - 3..];
            if Dir3::new(from_numbers(last)).is_none() {
                let found = format(&Kind::Numbers(VECTOR), last);
                return Err(RowError::word(at, name, "a direction", &found));
            }
        }
        Kind::Optional(kind) => {
            let there = !words.take("none");
            numbers.push(there.into());
            if there {
                parse_next(kind, words, name, numbers)?;
            }
        }
        Kind::List(kind) => {
            let count = words.whole(&format_args!("the number of {name}"))?;
            numbers.push(count.into());
            for i in 0..count {
                parse_next(kind, words, &format_args!("{name}[{i}]"), numbers)?;
            }
        }
        Kind::Record(record) => {
            for field in record.fields {
                parse_next(field.kind, words, &field.name, numbers)?;
            }
        }
        Kind::Choice(choices) => {
            let chosen = choices.iter().position(|(word, _)| words.take(word));
            let Some(i) = chosen else {
                let known: Vec<_> = choices.iter().map(|(word, _)| *word).collect();
                let expected = format!("one of the words {}", known.join(", "));
                return Err(words.refuse(name, &expected));
            };
            numbers.push(i as f64);
            parse_next(choices[i].1, words, name, numbers)?;
        }
    }
    Ok(())
}

fn format_next(kind: &Kind, numbers: &mut Numbers<'_>, line: &mut String) {
    match kind {
        Kind::Number => number(numbers.number() as f32, line),
        Kind::Whole => line.push_str(&(numbers.number() as u32).to_string()),
        Kind::Numbers(parts) => {
            for i in 0..parts.parts.len() {
                line.push_str(if i == 0 { "" } else { " " });
                format_next(&Kind::Number, numbers, line);
            }
        }
        Kind::Direction => format_next(&Kind::Numbers(VECTOR), numbers, line),
        Kind::Optional(_) if numbers.number() == 0.0 => line.push_str("none"),
        Kind::Optional(kind) => format_next(kind, numbers, line),
        Kind::List(kind) => {
            let count = numbers.number() as u32;
            line.push_str(&count.to_string());
            for _ in 0..count {
                line.push_str("  ");
                format_next(kind, numbers, line);
            }
        }
        Kind::Record(record) => {
            for (i, field) in record.fields.iter().enumerate() {
                line.push_str(if i == 0 { "" } else { "  " });
                format_next(field.kind, numbers, line);
            }
        }
        Kind::Choice(choices) => {
            if let Some((word, kind)) = choices.get(numbers.number() as usize) {
                line.push_str(word);
                line.push(' ');
                format_next(kind, numbers, line);
            }
        }
    }
}

fn parts_next(
    kind: &Kind,
    name: &str,
    numbers: &mut Numbers<'_>,
    parts: &mut Vec<(String, String)>,
) {
    match kind {
        Kind::Optional(kind) if numbers.0.as_slice().first() == Some(&1.0) => {
            numbers.number();
            parts_next(kind, name, numbers, parts);
        }
        Kind::Record(record) => {
            for field in record.fields {
                parts_next(field.kind, field.name, numbers, parts);
            }
        }
        Kind::List(kind) if kind.has_a_choice() => {
            for i in 0..numbers.number() as u32 {
                let mut line = String::new();
                format_next(kind, numbers, &mut line);
                parts.push((format!("{name}[{i}]"), line));
            }
        }
        _ => {
            let mut line = String::new();
            format_next(kind, numbers, &mut line);
            parts.push((name.to_owned(), line));
        }
    }
}

/// Appends a number as people write it: 2 and not 2.0, and nan in small letters.
fn number(v: f32, line: &mut String) {
    if v.is_nan() {
        return line.push_str("nan");
    }
    let written = write!(line, "{v:?}");
    debug_assert!(written.is_ok(), "a string takes all that is written to it");
    if line.ends_with(".0") {
        line.truncate(line.len() - 2);
    }
}

impl Row for f32 {
    const KIND: &'static Kind = &Kind::Number;

    fn put(&self, numbers: &mut Vec<f64>) {
        numbers.push((*self).into());
    }

    fn take(numbers: &mut Numbers<'_>) -> Self {
        numbers.number() as Self
    }
}

impl Row for u32 {
    const KIND: &'static Kind = &Kind::Whole;

    fn put(&self, numbers: &mut Vec<f64>) {
        numbers.push((*self).into());
    }

    fn take(numbers: &mut Numbers<'_>) -> Self {
        numbers.number() as Self
    }
}

impl Row for Dir3 {
    const KIND: &'static Kind = &Kind::Direction;

    fn put(&self, numbers: &mut Vec<f64>) {
        Vec3::put(self, numbers);
    }

    /// Any vector that has a direction; it is normalised.
    fn take(numbers: &mut Numbers<'_>) -> Self {
        Self::new_or(Vec3::take(numbers), Self::Z)
    }
}

impl<T: Row> Row for Option<T> {
    const KIND: &'static Kind = &Kind::Optional(T::KIND);

    fn put(&self, numbers: &mut Vec<f64>) {
        numbers.push(self.is_some().into());
        if let Some(value) = self {
            value.put(numbers);
        }
    }

    fn take(numbers: &mut Numbers<'_>) -> Self {
        (numbers.number() != 0.0).then(|| T::take(numbers))
    }
}

impl<T: Row> Row for Vec<T> {
    const KIND: &'static Kind = &Kind::List(T::KIND);

    fn put(&self, numbers: &mut Vec<f64>) {
        numbers.push(self.len() as f64);
        for value in self {
            value.put(numbers);
        }
    }

    fn take(numbers: &mut Numbers<'_>) -> Self {
        let count = numbers.number() as u32;
        (0..count).map(|_| T::take(numbers)).collect()
    }
}
