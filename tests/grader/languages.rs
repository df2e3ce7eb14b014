//! Workbooks in languages other than Rust: the starters, complete solutions of all exercises, and any language by `raybook.toml`.

#![cfg(unix)]

mod any;
mod drawn;
mod first_hour;
mod kept;
mod keys;
mod picture;
mod python;
mod solutions;
mod starters;
mod watched;

use crate::common::command::raybook_with;
use crate::common::starter::lay;
use raybook_grader::language::Language;
use raybook_grader::starter::cpp;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::LazyLock;

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
    let folder = home.join(name);
    if language == Language::Cpp {
        copy(&BUILT, &folder.join("build"));
    }
    folder
}

/// What `make` has made of the starter in C++, without a word. Each folder begins with a copy, in which only what is changed is compiled.
static BUILT: LazyLock<PathBuf> = LazyLock::new(|| {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("rays-in-cpp");
    lay(&folder, cpp::files());
    let flags = ["-s", "-j2", "CXXFLAGS=-O2 -g -Werror"];
    let said = succeeds(Command::new("make").args(flags).current_dir(&folder));
    assert_eq!(said, "", "not a word");
    folder.join("build")
});

/// Copies a folder: the files in it are the newest.
fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).expect("the folder can be made");
    for entry in fs::read_dir(from).expect("the folder can be read") {
        let path = entry.expect("the folder can be read").path();
        let copied = to.join(path.file_name().expect("it has a name"));
        if path.is_dir() {
            copy(&path, &copied);
        } else {
            fs::copy(path, copied).expect("it can be copied");
        }
    }
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
