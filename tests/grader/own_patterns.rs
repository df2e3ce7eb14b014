//! A student's own patterns: asked of answer programs of every kind, and made into sets of points.

#![cfg(unix)] // the programs are awk scripts

mod failures;
mod points;
pub(crate) mod scripts;

use raybook_grader::converse::{Limits, Program};
use raybook_grader::patterns::ask::ask;
use raybook_grader::patterns::got::{Got, Wanted};
use raybook_grader::patterns::{OWN_PATTERNS, OwnPattern};
use std::time::Duration;

/// The pattern of this name.
#[track_caller]
fn own(name: &str) -> &'static OwnPattern {
    let found = OWN_PATTERNS.iter().find(|own| own.name == name);
    found.unwrap_or_else(|| panic!("{name} is no exercise"))
}

/// A small number of points and a larger one, eight times each.
fn wanted() -> Wanted {
    Wanted {
        needed: vec![16],
        further: vec![200],
        realisations: 8,
        patience: Duration::from_secs(60),
    }
}

/// What an awk program makes of a pattern.
#[track_caller]
fn got(name: &str, awk: &str, wanted: &Wanted) -> Got {
    let program = Program {
        file: "awk".into(),
        arguments: vec![awk.into()],
        folder: std::path::PathBuf::new(),
        sandbox: None,
    };
    let limits = Limits::of(Duration::from_secs(5));
    ask(&program, own(name), wanted, limits).expect("awk can be started")
}
