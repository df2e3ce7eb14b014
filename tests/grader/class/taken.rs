//! References that students took.

use raybook_common::{STALE, measured};
use raybook_grader::class::taken::found;
use raybook_grader::class::tokens::tokens;
use raybook_grader::examine::Examiner;
use raybook_grader::language::Language;
use raybook_grader::{cases, starter};

/// The exercises that have a reference in a language, and that.
fn solved(language: Language) -> impl Iterator<Item = (&'static str, String)> {
    let names = cases::all().into_iter().map(<dyn Examiner>::name);
    names.filter_map(move |name| Some((name, starter::reference(language, name)?)))
}

/// The exercises that are watched in a language: whose reference is found.
fn watched(language: Language) -> impl Iterator<Item = &'static str> {
    solved(language).filter_map(move |(name, reference)| {
        let found = found(language, &tokens(language, &reference));
        found.contains(name).then_some(name)
    })
}

#[test]
fn the_exercises_of_the_course_have_a_reference_in_every_language() {
    for language in Language::ALL {
        assert!(
            solved(language).count() >= 64,
            "those that the course began with"
        );
        for (name, text) in solved(language) {
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
        let is_solved = |name: &&str| starter::reference(language, name).is_some();
        let same = watched(language).eq(watched(Language::Rust).filter(is_solved));
        assert!(same, "{}", language.name());
    }
    let names: Vec<_> = watched(Language::Rust)
        .map(|name| format!("`{name}`"))
        .collect();
    let told = format!("These are {}.\n", names.join(", "));
    assert_eq!(measured("watched", &told), told, "{STALE}");
}
