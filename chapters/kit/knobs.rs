//! Knobs: what a chapter's pictures depend on, as options of its command.
//!
//! A chapter declares its knobs once, as clap's [`Args`]. What a person or a page must know about them is read from clap's own
//! description. The name of a number's value is its range and its unit: `value_name = "5..200 mm"`. Where a knob changes another picture
//! than the main one, its sentence ends with that picture's name: "Points of each pattern, in `patterns`".

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::parser::ValueSource;
use clap::{Arg, ArgMatches, Args, Command, Error, ValueEnum};
use std::ops::RangeInclusive;

/// A knob, as its command describes it.
#[derive(Clone, Debug, PartialEq)]
pub struct Knob {
    /// Its name: `focal-length`.
    pub name: String,
    /// What it is, in a sentence.
    pub help: String,
    /// The picture that it changes, by its file's name.
    pub picture: String,
    /// Its default value; `None` if the chapter then draws without a value.
    pub default: Option<String>,
    /// What values it takes.
    pub kind: Kind,
    /// The knobs that cannot be turned together with this knob: focal length or field of view.
    pub instead_of: Vec<String>,
}

/// What values a knob takes.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// A number within a range, and its unit.
    Number(RangeInclusive<f64>, String),
    /// One of a few words.
    Choice(Vec<String>),
    /// The name of a file.
    File,
}

/// Adds the knobs of a chapter to a command.
pub fn add<K: Args>(command: Command) -> Command {
    let known: Vec<_> = command
        .get_arguments()
        .map(|arg| arg.get_id().clone())
        .collect();
    K::augment_args(command).mut_args(|arg| {
        let is_own = !known.contains(arg.get_id());
        // Then `--tilt -20` is a value, not another option.
        let is_number = is_own && range(&arg).is_some();
        if is_number {
            arg.allow_negative_numbers(true)
        } else {
            arg
        }
    })
}

/// The knobs of a command that has no other options.
pub fn of(command: &Command) -> Vec<Knob> {
    let excludes = |one: &Arg, other: &Arg| command.get_arg_conflicts_with(one).contains(&other);
    let knob = |arg: &Arg| {
        let sentence = arg.get_help().map(ToString::to_string).unwrap_or_default();
        let (help, picture) = picture(&sentence);
        Knob {
            name: name(arg),
            help: help.to_owned(),
            picture: picture.to_owned(),
            default: default(arg),
            kind: kind(arg),
            instead_of: command
                .get_arguments()
                .filter(|other| excludes(arg, other) || excludes(other, arg))
                .map(name)
                .collect(),
        }
    };
    command.get_arguments().map(knob).collect()
}

/// The arguments that turn a command's knobs as they were turned: `["--exponent=64"]`.
pub fn turned(knobs: &Command, matches: &ArgMatches) -> Vec<String> {
    let word = |arg: &Arg| {
        let id = arg.get_id().as_str();
        let by_hand = matches.value_source(id) == Some(ValueSource::CommandLine);
        let value = by_hand.then(|| matches.get_raw(id)).flatten()?.next()?;
        Some(format!("--{}={}", name(arg), value.to_string_lossy()))
    };
    knobs.get_arguments().filter_map(word).collect()
}

/// Checks that every number is within its range.
///
/// # Errors
/// Names the knob, its range and its unit.
pub fn check(knobs: &Command, matches: &ArgMatches) -> Result<(), Error> {
    for arg in knobs.get_arguments() {
        let Some((range, unit)) = range(arg) else {
            continue;
        };
        let given = matches.get_raw(arg.get_id().as_str()).into_iter().flatten();
        for word in given.map(|word| word.to_string_lossy()) {
            if !is_within(&range, &word) {
                return Err(wrong(arg, &word, &range, &unit));
            }
        }
    }
    Ok(())
}

/// An error of clap's; of a number that cannot be read it names the range and the unit, as [`check`] does.
pub fn plain(knobs: &Command, error: Error) -> Error {
    let text = |kind| match error.get(kind) {
        Some(ContextValue::String(text)) => Some(text.as_str()),
        _ => None,
    };
    let option = text(ContextKind::InvalidArg).unwrap_or_default();
    let value = text(ContextKind::InvalidValue)
        .unwrap_or_default()
        .to_owned();
    let is_it = |arg: &&Arg| option.split(' ').next() == Some(&format!("--{}", name(arg)));
    let is_unreadable = error.kind() == ErrorKind::ValueValidation;
    let arg = knobs.get_arguments().find(is_it).filter(|_| is_unreadable);
    let number = arg.and_then(|arg| Some((arg, range(arg)?)));
    number.map_or_else(
        || error,
        |(arg, (range, unit))| wrong(arg, &value, &range, &unit),
    )
}

fn is_within(range: &RangeInclusive<f64>, word: &str) -> bool {
    word.parse().is_ok_and(|value: f64| range.contains(&value))
}

/// What is said of a word that is no value of a number. One within its range is refused because a part of one is none.
fn wrong(arg: &Arg, word: &str, range: &RangeInclusive<f64>, unit: &str) -> Error {
    let number = if is_within(range, word) {
        "a whole number"
    } else {
        "a number"
    };
    let (low, high) = (range.start(), range.end());
    let message = format!(
        "--{} {word}: {number} from {low} to {high}{}\n",
        name(arg),
        of_unit(unit)
    );
    Error::raw(ErrorKind::ValueValidation, message)
}

/// Why an argument is refused, in a sentence: the first line of what clap prints, without its `error: `.
pub fn sentence(error: &Error) -> String {
    let text = error.to_string();
    let line = text.lines().next().unwrap_or_default();
    line.trim_start_matches("error: ").to_owned()
}

/// The word on the command line that stands for the value of a choice.
pub fn word(choice: &impl ValueEnum) -> String {
    let value = choice.to_possible_value();
    value.map_or_else(String::new, |value| value.get_name().to_owned())
}

impl Knob {
    /// Another value than the default, for an example; `None` if only the user knows a value.
    pub fn example(&self) -> Option<String> {
        match &self.kind {
            Kind::Number(range, _) => {
                let default: f64 = self.default.as_ref()?.parse().ok()?;
                let upper = 0.25 * range.start() + 0.75 * range.end();
                let fits = |value: &f64| *value != default && range.contains(value);
                [2.0 * default, upper.round()]
                    .iter()
                    .find(|value| fits(value))
                    .map(f64::to_string)
            }
            Kind::Choice(words) => words
                .iter()
                .rfind(|word| Some(*word) != self.default.as_ref())
                .cloned(),
            Kind::File => None,
        }
    }

    /// A value with its name and unit, for a label: `exponent 64`.
    pub fn label(&self, value: &str) -> String {
        let unit = match &self.kind {
            Kind::Number(_, unit) => of_unit(unit),
            _ => String::new(),
        };
        format!("{} {value}{unit}", self.name.replace('-', " "))
    }
}

fn name(arg: &Arg) -> String {
    arg.get_long().unwrap_or(arg.get_id().as_str()).to_owned()
}

/// The parts of a knob's sentence: what the knob is, and the picture that it changes.
fn picture(sentence: &str) -> (&str, &str) {
    let named = sentence.strip_suffix('`');
    named
        .and_then(|rest| rest.rsplit_once(", in `"))
        .unwrap_or((sentence, "picture"))
}

fn default(arg: &Arg) -> Option<String> {
    let value = arg.get_default_values().first()?;
    Some(value.to_string_lossy().into_owned())
}

fn kind(arg: &Arg) -> Kind {
    let words: Vec<_> = arg
        .get_possible_values()
        .iter()
        .map(|value| value.get_name().to_owned())
        .collect();
    match range(arg) {
        Some((range, unit)) => Kind::Number(range, unit),
        None if words.is_empty() => Kind::File,
        None => Kind::Choice(words),
    }
}

/// The range and the unit that are a number's value name: `5..200 mm`.
fn range(arg: &Arg) -> Option<(RangeInclusive<f64>, String)> {
    let text = arg.get_value_names()?.first()?;
    let (range, unit) = text.split_once(' ').unwrap_or((text, ""));
    let (low, high) = range.split_once("..")?;
    Some((low.parse().ok()?..=high.parse().ok()?, unit.to_owned()))
}

/// A unit after a number: a degree sign follows without a space.
fn of_unit(unit: &str) -> String {
    match unit {
        "" | "°" => unit.to_owned(),
        unit => format!(" {unit}"),
    }
}
