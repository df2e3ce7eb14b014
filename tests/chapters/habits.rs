//! Habits that every file keeps: what pages promise, who touches files, where tests stand, and what comments call a number.

use raybook_chapters::MEASURED;
use raybook_common::project;
use raybook_common::source::{read, rust_files};
use std::collections::BTreeSet;

#[test]
fn where_the_same_pictures_are_promised_those_that_show_times_are_named() {
    let measured: BTreeSet<_> = MEASURED.into();
    for (file, promise) in [
        (
            "README.md",
            "The same seed draws the same\npictures, bit for bit,",
        ),
        (
            "book/src/introduction.md",
            "The same program draws the same picture, bit for bit,",
        ),
    ] {
        let text = read(file);
        let (_, promised) = text
            .split_once(promise)
            .unwrap_or_else(|| panic!("{file} promises"));
        let (sentence, _) = promised.split_once("\n\n").unwrap_or((promised, ""));
        let code = sentence.split('`').skip(1).step_by(2);
        let named: BTreeSet<_> = code.filter(|name| name.starts_with("ch")).collect();
        assert_eq!(
            named, measured,
            "{file} names the figures of measured times"
        );
    }
}

/// Where files may be touched. All others ask the store, which knows what a file is, and writes it whole or not at all.
const OPENERS: [(&str, &str, &str); 11] = [
    (
        "grader/src",
        "commands/hidden.rs",
        "a key may come through a pipe",
    ),
    (
        "grader/src",
        "sandbox/",
        "it encloses programs, and tries to get out",
    ),
    ("src", "store.rs", "it is the store"),
    ("grader/src", "lock.rs", "it opens a folder, to lock it"),
    ("grader/src", "contain.rs", "it reads /proc"),
    ("grader/src", "stat.rs", "it reads /proc"),
    (
        "grader/src",
        "class/journal.rs",
        "it only ever adds, and waits for the disk",
    ),
    (
        "grader/src",
        "class/stage.rs",
        "a folder of its own, for the sandbox, which is removed in the end",
    ),
    (
        "grader/src",
        "class/files/",
        "hand-ins are read within the limits of the course, and no link is followed",
    ),
    (
        "grader/src",
        "class/shortage.rs",
        "the kernel's counters are no files of anybody's",
    ),
    ("grader/src", "progress.rs", "it renames what is damaged"),
];

/// What touches files.
const TOUCHES: [&str; 9] = [
    "File::open",
    "File::create",
    "File::options",
    "OpenOptions",
    "fs::write(",
    "fs::read(",
    "fs::read_to_string(",
    "fs::rename(",
    "fs::copy(",
];

#[test]
fn files_are_touched_in_one_place() {
    let mut touched = BTreeSet::new();
    for folder in ["src", "workbook/src", "chapters", "grader/src"] {
        for (file, text) in rust_files(folder) {
            for touch in TOUCHES.iter().filter(|touch| text.contains(**touch)) {
                // A name that ends so is another function.
                let is_own =
                    |part: &str| !part.ends_with(|c: char| c.is_alphanumeric() || c == '_');
                if !text.match_indices(touch).any(|(at, _)| is_own(&text[..at])) {
                    continue;
                }
                let place = OPENERS
                    .iter()
                    .find(|(of, name, _)| *of == folder && file.starts_with(name));
                assert!(
                    place.is_some(),
                    "{folder}/{file} calls {touch}: files are read and written by src/store.rs"
                );
                touched.insert(place);
            }
        }
    }
    assert_eq!(touched.len(), OPENERS.len(), "each still touches files");
}

/// No library is compiled for tests (`test = false` in its manifest): one inside it would never run.
#[test]
fn no_test_stands_in_a_library() {
    for folder in ["src", "workbook/src", "chapters", "grader/src"] {
        for (file, text) in rust_files(folder) {
            for mark in ["#[test]", "cfg(test)", "cfg(all(test"] {
                assert!(
                    !text.contains(mark),
                    "{folder}/{file} has {mark}: tests stand in tests/, and reach what is not public through `inside`"
                );
            }
        }
    }
}

/// Words in the place of a parameter's name, but for comparisons ("so many that").
const NAMELESS: [&str; 13] = [
    "/// So many ",
    "/// So much ",
    "/// So often ",
    "/// By so much ",
    "of so many ",
    "with so many ",
    "at most so ",
    "by so many ",
    "by so much ",
    "than so many",
    "for so long ",
    " stands so many ",
    ": so many ",
];

#[test]
fn comments_and_pages_call_a_number_by_its_name() {
    let mut comments = Vec::new();
    for folder in [
        "src",
        "workbook/src",
        "chapters",
        "grader/src",
        "tests",
        "benches",
    ] {
        for (file, text) in rust_files(folder) {
            let lines = (1..).zip(text.lines().map(str::trim_start));
            let here = lines.filter(|(_, line)| line.starts_with("//"));
            comments
                .extend(here.map(|(at, line)| (format!("{folder}/{file}:{at}"), line.to_owned())));
        }
    }
    for entry in std::fs::read_dir(project("book/src")).expect("the book is there") {
        let path = entry.expect("the folder can be read").path();
        if path.extension().is_some_and(|kind| kind == "md") {
            let text = std::fs::read_to_string(&path).expect("a page is text");
            let lines = (1..).zip(text.lines());
            comments.extend(
                lines.map(|(at, line)| (format!("{}:{at}", path.display()), line.to_owned())),
            );
        }
    }
    for (place, line) in comments {
        let nameless = NAMELESS.iter().find(|words| {
            let after = line.split_once(**words).map(|(_, after)| after);
            after.is_some_and(|after| !after.starts_with("that "))
        });
        assert!(
            nameless.is_none(),
            "{place}: `{line}`: say the parameter's name, or what is counted"
        );
    }
}
