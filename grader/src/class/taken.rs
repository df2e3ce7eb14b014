//! References that a student took instead of writing the function.
//!
//! `raybook solve` records them in a file of the workbook, which is handed in with it. Who deletes the file is found out where the
//! reference's text is in the hand-in, token by token, and is too long to be anybody's own.

use super::tokens::{Token, tokens};
use crate::{cases, library};
use std::collections::BTreeSet;
use std::sync::OnceLock;

/// The file in a workbook in which `raybook solve` records what was taken: a name of an exercise on each line.
pub const FILE: &str = "references-taken.txt";

/// A reference of fewer tokens can be a student's own: there are few ways to write it.
const LONG: usize = 120;

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

/// The exercises whose reference stands in these tokens of a hand-in in Rust.
pub fn found(handed_in: &[Token]) -> BTreeSet<&'static str> {
    let stands = |reference: &Vec<Token>| {
        let kinds = |tokens: &[Token]| tokens.iter().map(|token| token.exact).collect::<Vec<_>>();
        let (all, part) = (kinds(handed_in), kinds(reference));
        all.windows(part.len()).any(|window| window == part)
    };
    let found = references()
        .iter()
        .filter(|(_, reference)| stands(reference));
    found.map(|(name, _)| *name).collect()
}

/// The references that are long enough.
fn references() -> &'static [(&'static str, Vec<Token>)] {
    static REFERENCES: OnceLock<Vec<(&str, Vec<Token>)>> = OnceLock::new();
    REFERENCES.get_or_init(|| {
        let of = |name| Some((name, tokens(library::reference(name)?)));
        let all = cases::all()
            .into_iter()
            .filter_map(|examiner| of(examiner.name()));
        all.filter(|(_, tokens)| tokens.len() >= LONG).collect()
    })
}
