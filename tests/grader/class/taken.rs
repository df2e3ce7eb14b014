//! References that students took.

use raybook_common::project;
use raybook_grader::class::taken::found;
use raybook_grader::class::tokens::tokens;
use raybook_grader::examine::Examiner;
use raybook_grader::language::Language;
use raybook_grader::{cases, starter};
use std::fs;

/// The exercises that are watched in a language: whose reference is found.
fn watched(language: Language) -> impl Iterator<Item = &'static str> {
    let names = cases::all().into_iter().map(<dyn Examiner>::name);
    names.filter(move |name| {
        let reference = starter::reference(language, name).expect(name);
        found(language, &tokens(language, &reference)).contains(name)
    })
}

#[test]
fn every_exercise_has_a_reference_in_every_language() {
    for language in Language::ALL {
        for examiner in cases::all() {
            let name = examiner.name();
            let text = starter::reference(language, name).expect(name);
            assert!(text.contains(name) || language == Language::Rust, "{text}");
            assert!(
                text.trim_end().ends_with('}') || language == Language::Python,
                "{text}"
            );
        }
    }
}

#[test]
fn a_copied_reference_is_found_and_another_text_is_not() {
    for language in Language::ALL {
        for name in watched(language) {
            let reference = starter::reference(language, name).expect("it has one");
            let copied = format!("x = 1\n\n{}\n\ny = 2\n", reference.replace("    ", "  "));
            let names = found(language, &tokens(language, &copied));
            assert!(names.contains(name), "{name}");
            let own = reference.replace('(', "((");
            let names = found(language, &tokens(language, &own));
            assert!(!names.contains(name), "{name}: {own}");
        }
    }
}

#[test]
fn the_same_exercises_are_watched_in_every_language_and_the_book_names_them() {
    for language in Language::ALL {
        let same = watched(language).eq(watched(Language::Rust));
        assert!(same, "{}", language.name());
    }
    let page = fs::read_to_string(project("book/src/grading.md")).expect("a page is text");
    let names: Vec<_> = watched(Language::Rust)
        .map(|name| format!("`{name}`"))
        .collect();
    let text: Vec<_> = page.split_whitespace().collect();
    let sentence = names.join(", ");
    assert!(
        text.join(" ").contains(&format!("These are {sentence}.")),
        "{sentence}"
    );
}
