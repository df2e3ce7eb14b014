//! Workbooks in languages other than Rust: the starters, complete solutions of all exercises, and any language by `raybook.toml`.

#![cfg(unix)]

mod any;
mod drawn;
mod first_hour;
mod keys;
mod picture;
mod python;
mod solutions;
mod starters;
mod watched;

use crate::common::command::raybook_with;
use raybook_grader::language::Language;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Whether there is this program; else the test says so.
fn there_is(program: &str) -> bool {
    let output = Command::new(program).arg("--version").output();
    let there = output.is_ok_and(|output| output.status.success());
    if !there {
        println!("there is no {program} here: what takes it is not tried");
    }
    there
}

/// The path of a student who has no Rust: the system's programs only.
const WITHOUT_RUST: (&str, &str) = ("PATH", "/usr/bin:/bin");

/// A folder of this name, as `raybook new` makes it where there is no Rust.
fn new(home: &Path, name: &str, language: Language) -> PathBuf {
    let words = ["new", name, "--language", language.name()];
    let (code, said) = raybook_with(home, &words, &[WITHOUT_RUST]);
    assert!(code == 0 && said.contains("raybook check"), "{said}");
    home.join(name)
}

/// What a program says on both outputs, if it succeeds.
fn succeeds(command: &mut Command) -> String {
    let Output {
        status,
        stdout,
        stderr,
    } = command.output().expect("the program runs");
    let said = [stdout, stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
    let said = said.concat();
    assert!(status.success(), "{command:?}: {said}");
    said
}
