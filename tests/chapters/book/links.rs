//! Links between the book's pages, and the places to which they lead.

use super::{page, pages};
use raybook_common::project;
use raybook_workbook::curriculum::{self, Chapter};
use std::collections::BTreeSet;

#[test]
fn every_link_between_pages_leads_somewhere() {
    let mut followed = 0;
    for (name, text) in pages() {
        for link in links(&text) {
            followed += 1;
            let wrong = wrong(&name, &link);
            assert!(
                wrong.is_none(),
                "book/src/{name}: {link} leads nowhere: {}",
                wrong.unwrap_or_default()
            );
        }
    }
    assert!(followed > 300, "the links were seen: {followed}");
}

#[test]
fn a_link_that_leads_nowhere_is_noticed() {
    for (link, right) in [
        ("ch03_sphere.md", true),
        ("ch03_sphere.md#turn-sphere_hit", true),
        ("ch03_sphere.md#figure-roots", true),
        ("ch03_sphere.md#roots-without-cancellation", true),
        ("#what-we-need", true),
        ("ch26_sphere.md", false),
        ("ch03_sphere.md#turn-sphere_hitt", false),
        ("ch03_sphere.md#figure-planes", false),
        ("#what-nobody-needs", false),
    ] {
        assert_eq!(wrong("why.md", link).is_none(), right, "{link}");
    }
}

#[test]
fn every_file_that_a_page_names_is_in_the_repository() {
    const FOLDERS: [&str; 6] = [
        "src/",
        "tests/",
        "chapters/",
        "grader/",
        "golden/",
        "benches/",
    ];
    let mut found = 0;
    for (name, text) in pages() {
        let codes = text.split('`').skip(1).step_by(2);
        let is_file = |code: &&str| {
            FOLDERS.iter().any(|folder| code.starts_with(folder))
                && !code.contains(char::is_whitespace)
        };
        for file in codes.filter(is_file) {
            found += 1;
            assert!(
                project(file).exists(),
                "book/src/{name}: there is no file `{file}`"
            );
        }
    }
    assert!(found >= 10, "files are named: {found}");
}

/// The links of a page to pages of the book.
pub(super) fn links(text: &str) -> Vec<String> {
    let ends = text.split("](").skip(1);
    let links = ends.filter_map(|rest| rest.split_once(')').map(|(link, _)| link));
    let inside = |link: &&str| link.starts_with('#') || link.contains(".md");
    links.filter(inside).map(str::to_owned).collect()
}

/// What is wrong with a link that stands on a page, if anything is.
fn wrong(on: &str, link: &str) -> Option<String> {
    let (file, place) = link.split_once('#').unwrap_or((link, ""));
    let file = if file.is_empty() { on } else { file };
    if pages().iter().all(|(name, _)| name != file) {
        return Some(format!("there is no page {file}"));
    }
    let found = place.is_empty() || places(file).contains(place);
    (!found).then(|| format!("{file} has no place {place}"))
}

/// The places of a page: its headings, its terms, its exercises and its figures.
fn places(file: &str) -> BTreeSet<String> {
    let text = page(file);
    let chapter = curriculum::find(file.trim_end_matches(".md"));
    let exercises = chapter.map_or(&[][..], Chapter::exercises).iter();
    let mut places: BTreeSet<_> = exercises
        .map(|asked| format!("turn-{}", asked.name))
        .collect();
    let mut lines = text.lines().peekable();
    while let Some(line) = lines.next() {
        let word = |start: &str| {
            Some(
                line.strip_prefix(start)?
                    .split([' ', '}'])
                    .next()?
                    .to_owned(),
            )
        };
        let is_term = lines.peek().is_some_and(|next| next.starts_with(": "));
        if line.starts_with("##") || is_term {
            places.insert(place(line.trim_start_matches('#').trim()));
        } else if let Some(figure) = word("{{figure ") {
            // That of another chapter is `ch03_sphere/roots`.
            let (_, name) = figure.split_once('/').unwrap_or(("", &figure));
            places.insert(format!("figure-{name}"));
        }
    }
    places
}

/// The place of a heading or a term, as mdBook calls it.
pub(super) fn place(heading: &str) -> String {
    let letters = heading.chars().filter_map(|c| match c {
        c if c.is_alphanumeric() || c == '_' || c == '-' => Some(c.to_ascii_lowercase()),
        c if c.is_whitespace() => Some('-'),
        _ => None,
    });
    letters.collect()
}
