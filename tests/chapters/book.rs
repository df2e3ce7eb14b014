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

#[test]
fn vectors_are_written_as_the_notation_page_says() {
    // A letter of macros.txt is written by its name, in every page but the table of the letters.
    let macros = fs::read_to_string(project("book/macros.txt")).expect("the macros are there");
    let named = macros.lines().filter_map(|line| line.split_once(':'));
    let named: Vec<_> = named.filter(|(name, _)| name.starts_with('\\')).collect();
    assert!(named.len() > 2, "the macros were read: {named:?}");
    for (page, text) in pages() {
        for (mark, instead) in [
            ("\\hat", "\\mathbf"),
            ("\\vec", "\\mathbf"),
            ("\u{302}", "font-weight=\"bold\""),
        ] {
            assert!(
                !text.contains(mark),
                "book/src/{page} has a vector with {mark}; all vectors are bold: {instead}"
            );
        }
        for (name, letter) in &named {
            let letter = letter.trim_matches(['{', '}']);
            let is_vector = letter.starts_with("\\mathbf");
            let ends = |at: usize| !text[at + letter.len()..].starts_with(char::is_alphabetic);
            let typed = text.match_indices(letter).any(|(at, _)| ends(at));
            assert!(
                !(is_vector && typed),
                "book/src/{page} has {letter}, which is called {name}"
            );
        }
    }
}

#[test]
fn sentences_are_short() {
    /// Maximum number of words, for readers whose language is not English.
    const LONGEST: usize = 40;
    let mut counted = 0;
    for (page, text) in pages() {
        for sentence in sentences(&text) {
            counted += 1;
            let words = sentence.split_whitespace().count();
            assert!(
                words <= LONGEST,
                "book/src/{page}: a sentence of {words} words, where {LONGEST} are allowed; make two of it: {sentence}"
            );
        }
    }
    assert!(counted > 5000, "{counted} sentences were counted");
}

#[test]
fn subscripts_are_set_below_the_line() {
    for (page, text) in pages() {
        for figure in text.split("<figure>").skip(1) {
            let figure = figure.split("</figure>").next().unwrap_or_default();
            let words = figure.split('>').filter_map(|part| part.split('<').next());
            for words in words {
                assert!(
                    !words.contains('_'),
                    "book/src/{page}: write <tspan dy=\"5\"> or <sub> in a drawing, not _: {words}"
                );
            }
        }
    }
}

/// The sentences of a page: what ends with a full stop, a question mark, a colon or a semicolon, without listings, drawings, tables and
/// displayed formulas.
fn sentences(text: &str) -> Vec<String> {
    let (mut sentences, mut sentence) = (Vec::new(), String::new());
    let mut fenced = false;
    for line in text.lines() {
        fenced ^= line.starts_with("```") || line.starts_with("$$") != line.ends_with("$$");
        let ends = line.is_empty() || line.starts_with("- ");
        if ends || fenced {
            sentences.push(std::mem::take(&mut sentence));
        }
        if fenced || line.starts_with(['<', '|', '{', '#', '$', '`']) {
            continue;
        }
        for word in line.split_whitespace() {
            sentence.extend([word, " "]);
            let bare = word.trim_end_matches(['*', ')', '"']);
            if bare.ends_with(['.', '?', '!', ':', ';']) {
                sentences.push(std::mem::take(&mut sentence));
            }
        }
    }
    sentences.push(sentence);
    sentences.retain(|sentence| !sentence.is_empty());
    sentences
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
