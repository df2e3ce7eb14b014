//! The glossary: standard terms in order, each with a definition and the lesson that explains the term.

use super::links::{links, place};
use super::{page, pages};
use std::collections::BTreeSet;

/// Minimum number of the field's standard terms.
const LEAST: usize = 150;

#[test]
fn terms_are_sorted_and_each_has_a_definition_and_a_link() {
    let terms = terms();
    assert!(terms.len() >= LEAST, "{} terms", terms.len());
    for pair in terms.windows(2) {
        let [before, after] = [&pair[0].0, &pair[1].0];
        assert!(
            letters(before) < letters(after),
            "book/src/glossary.md: “{after}” stands after “{before}”: terms are sorted, and none is there twice"
        );
    }
    for (term, definition) in &terms {
        assert!(
            definition.len() > 20 && !links(definition).is_empty(),
            "book/src/glossary.md: “{term}” needs a definition and a link to its lesson: {definition}"
        );
    }
    let places: BTreeSet<_> = terms.iter().map(|(term, _)| place(term)).collect();
    assert_eq!(
        places.len(),
        terms.len(),
        "each term has a place of its own"
    );
}

#[test]
fn lessons_lead_to_the_glossary() {
    let lessons = pages()
        .into_iter()
        .filter(|(name, _)| name.starts_with("ch"));
    for (name, text) in lessons {
        assert!(
            text.contains("](glossary.md#"),
            "book/src/{name}: link the first use of a standard term to the glossary"
        );
    }
}

/// A term as it is sorted: without capitals and accents.
fn letters(term: &str) -> String {
    let plain = |letter| match letter {
        'é' => 'e',
        'ö' => 'o',
        _ => letter,
    };
    term.to_lowercase().chars().map(plain).collect()
}

/// The terms and their definitions.
fn terms() -> Vec<(String, String)> {
    let text = page("glossary.md");
    let lines: Vec<_> = text.lines().collect();
    let pairs = lines.windows(2);
    let terms =
        pairs.filter_map(|pair| Some((pair[0].to_owned(), pair[1].strip_prefix(": ")?.to_owned())));
    terms.collect()
}
