//! The book's pages: Rust in them is never typed, and no link leads nowhere. What a lesson must have is tested with the grader, which
//! expands the directives.

mod bibliography;
mod glossary;
mod lecture;
mod links;

use raybook_common::project;
use std::fs;

#[test]
fn no_listing_is_typed_by_hand() {
    for (page, text) in pages() {
        let mut open = false;
        for (number, line) in (1..).zip(text.lines()) {
            if let Some(language) = line.trim_start().strip_prefix("```") {
                open = !open;
                assert!(
                    !language.starts_with("rust"),
                    "book/src/{page}:{number}: Rust comes from the course, by {{{{listing …}}}} or {{{{reference …}}}}"
                );
            }
            assert!(
                !line.contains("{{#include"),
                "book/src/{page}:{number}: mdBook is silent about an anchor that is not there; use {{{{listing …}}}}"
            );
        }
        assert!(!open, "book/src/{page}: a ``` is not closed");
    }
}

/// The text of a page.
fn page(name: &str) -> String {
    let path = project("book/src").join(name);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The pages, by name.
fn pages() -> Vec<(String, String)> {
    let entries = fs::read_dir(project("book/src"))
        .expect("book/src is there")
        .flatten();
    let pages: Vec<_> = entries
        .filter(|entry| entry.path().extension().is_some_and(|e| e == "md"))
        .map(|entry| {
            (
                entry.file_name().to_string_lossy().into_owned(),
                fs::read_to_string(entry.path()).expect("a page is text"),
            )
        })
        .collect();
    assert!(pages.len() > 25, "the book has pages");
    pages
}
