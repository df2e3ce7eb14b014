//! References that a student took instead of writing the function.
//!
//! `raybook solve` records them in a file of the workbook, which is handed in with it. Who deletes the file is found out where the
//! reference's text is in the hand-in, token by token, and is too long to be anybody's own.

use super::tokens::{Token, tokens};
use crate::language::Language;
use crate::{cases, starter};
use std::collections::BTreeSet;
use std::sync::OnceLock;

/// The file in a workbook in which `raybook solve` records what was taken: a name of an exercise on each line.
pub const FILE: &str = "references-taken.txt";

/// A reference of fewer tokens can be a student's own: part of them is the signature, which is given, and there are few ways to write
/// the rest. Each language must have as many, so that an exercise is watched in all of them or in none.
const LONG: usize = 95;

/// The text of the record with these exercises added.
pub fn record(text: &str, exercises: &[&str]) -> String {
    let mut names: BTreeSet<&str> = text.lines().map(str::trim).collect();
    names.extend(exercises);
    names.retain(|name| !name.is_empty());
    names.into_iter().flat_map(|name| [name, "\n"]).collect()
}

/// The exercises that a record names.
pub fn recorded(text: &str) -> BTreeSet<&'static str> {
    let find = |name: &str| Some(cases::find(name.trim())?.name());
    text.lines().filter_map(find).collect()
}

/// The exercises whose reference in a language stands in these tokens of a hand-in.
pub fn found(language: Language, handed_in: &[Token]) -> BTreeSet<&'static str> {
    let stands = |reference: &Vec<Token>| {
        let kinds = |tokens: &[Token]| tokens.iter().map(|token| token.exact).collect::<Vec<_>>();
        let (all, part) = (kinds(handed_in), kinds(reference));
        all.windows(part.len()).any(|window| window == part)
    };
    let found = references(language)
        .iter()
        .filter(|(_, reference)| stands(reference));
    found.map(|(name, _)| *name).collect()
}

/// An exercise with the tokens of its reference.
type Reference = (&'static str, Vec<Token>);

/// The references of the exercises that have long ones in every language.
fn references(language: Language) -> &'static [Reference] {
    static REFERENCES: [OnceLock<Vec<Reference>>; 3] = [const { OnceLock::new() }; 3];
    REFERENCES[language as usize].get_or_init(|| {
        let of = |language, name| Some(tokens(language, &starter::reference(language, name)?));
        let is_long = |language, name| of(language, name).is_some_and(|it| it.len() >= LONG);
        let is_watched = |name| Language::ALL.iter().all(|&each| is_long(each, name));
        cases::all()
            .into_iter()
            .filter(|examiner| is_watched(examiner.name()))
            .filter_map(|examiner| Some((examiner.name(), of(language, examiner.name())?)))
            .collect()
    })
}
