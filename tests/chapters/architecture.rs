//! The rules about the house: floors, claims and the length of files.

use raybook_chapters::LESSONS;
use raybook_common::project;
use raybook_common::source::{file_of, read, rust_files, top_module, used_paths};
use std::collections::BTreeMap;

#[test]
fn a_module_uses_only_lower_floors() {
    let floors = floors();
    let mut uses = 0;
    for (file, text) in rust_files("src") {
        let Some(&place) = floors.get(top_module(&file)) else {
            assert!(
                !file.contains('/'),
                "{file}: its module is not in the map of floors in src/lib.rs"
            );
            continue;
        };
        for path in used_paths(&text, "crate") {
            let module = path.split("::").next().expect("a path has a first part");
            let used = *floors
                .get(module)
                .unwrap_or_else(|| panic!("{file}: `{module}` is not in the map of floors"));
            assert!(
                used < place || module == top_module(&file),
                "{file} uses {path}: a module may use only lower floors, and what is to its left on its own"
            );
            uses += 1;
        }
    }
    assert!(uses > 50, "the test must see the uses; it saw {uses}");
}

#[test]
fn every_file_of_the_course_is_new_in_exactly_one_chapter() {
    let floors = floors();
    let mut claims = BTreeMap::<&str, Vec<&str>>::new();
    for lesson in LESSONS {
        for file in lesson.new_files() {
            assert!(
                project("src").join(file).is_file(),
                "{} claims src/{file}, which does not exist",
                lesson.name
            );
            claims.entry(file).or_default().push(lesson.name);
        }
    }
    for (file, _) in rust_files("src") {
        if floors
            .get(top_module(&file))
            .is_some_and(|&(floor, _)| floor <= 6)
        {
            let by = claims.remove(file.as_str()).unwrap_or_default();
            assert_eq!(
                by.len(),
                1,
                "src/{file} must be on the `New:` lines of exactly one chapter, not of {by:?}"
            );
        }
    }
    assert!(
        claims.is_empty(),
        "only files on floors 0 to 6 are claimed, not {claims:?}"
    );
}

#[test]
fn no_chapter_uses_a_file_that_a_later_one_claims() {
    let chapter_of: BTreeMap<_, _> = LESSONS
        .iter()
        .flat_map(|lesson| {
            lesson
                .new_files()
                .into_iter()
                .map(|file| (file, lesson.chapter().number()))
        })
        .collect();
    let sources: BTreeMap<_, _> = rust_files("src").collect();
    let mut uses = 0;
    for lesson in LESSONS {
        let own = lesson
            .new_files()
            .into_iter()
            .map(|file| (file, sources[file].as_str(), "crate"));
        for (file, text, root) in own.chain([(lesson.name, lesson.source, "raybook")]) {
            for path in used_paths(text, root) {
                let used = file_of(&path, &sources);
                let Some(&by) = chapter_of.get(used.as_str()) else {
                    continue;
                }; // higher floors belong to all
                assert!(
                    by <= lesson.chapter().number(),
                    "{file} of {} uses {path} (src/{used}), which chapter {by} introduces",
                    lesson.name
                );
                uses += 1;
            }
        }
    }
    assert!(uses > 30, "the test must see the uses; it saw {uses}");
}

#[test]
fn no_file_is_long() {
    for folder in ["src", "chapters", "tests", "benches"] {
        for (file, text) in rust_files(folder) {
            let (path, lines) = (format!("{folder}/{file}"), text.lines().count());
            assert!(
                lines <= 200,
                "{path} has {lines} lines; one idea needs at most 200"
            );
        }
    }
}

/// Module → floor and place on it from the left, from the table in `lib.rs`.
fn floors() -> BTreeMap<String, (u32, usize)> {
    let text = read("src/lib.rs");
    let rows = text
        .lines()
        .filter_map(|line| line.strip_prefix("//! | ")?.split_once(" | "));
    let floors: BTreeMap<_, _> = rows
        .filter_map(|(floor, modules)| {
            Some((floor.parse::<u32>().ok()?, modules.trim_end_matches(" |")))
        })
        .flat_map(|(floor, modules)| {
            modules
                .split(", ")
                .enumerate()
                .map(move |(place, module)| (module.to_owned(), (floor, place)))
        })
        .collect();
    assert!(
        floors.len() >= 10,
        "the map of floors in src/lib.rs has a row per floor"
    );
    floors
}

#[test]
fn uses_are_taken_apart() {
    let text = "use crate::architecture::a::{self, b::{C, d::E}, F};\nfn f() { crate::architecture::g::h() } // crate::architecture::not::this";
    assert_eq!(
        used_paths(text, "crate"),
        ["a", "a::b::C", "a::b::d::E", "a::F", "g::h"],
        "each path on its own"
    );
}
