//! The bibliography: all that lessons recommend, with the same title and the same DOI.

use super::{page, pages};

#[test]
fn what_a_lesson_recommends_is_in_the_bibliography() {
    let bibliography = page("bibliography.md");
    let entries: Vec<_> = bibliography
        .lines()
        .filter_map(|line| line.strip_prefix("- "))
        .collect();
    assert!(entries.len() > 80, "{} entries", entries.len());
    let mut compared = 0;
    for (name, text) in pages() {
        let Some((_, reading)) = text.split_once("\n## Further reading\n") else {
            continue;
        };
        for work in reading.trim().split("\n- ") {
            let work = work.split_whitespace().collect::<Vec<_>>().join(" ");
            let title = title(&work).unwrap_or_else(|| panic!("book/src/{name}: no title: {work}"));
            let found = entries.iter().find(|entry| entry.contains(title));
            let entry = found
                .unwrap_or_else(|| panic!("book/src/bibliography.md lacks “{title}” of {name}"));
            assert_eq!(doi(&work), doi(entry), "the DOI of “{title}” in {name}");
            assert!(
                entry.contains(&format!("]({name})")),
                "book/src/bibliography.md: “{title}” is recommended in {name} too"
            );
            compared += 1;
        }
    }
    assert!(compared > 90, "{compared} recommendations were compared");
}

/// The title of a work: the first part in quotation marks or in italics after the year.
fn title(work: &str) -> Option<&str> {
    let rest = work.split_once(": ")?.1;
    let mark = rest.chars().next().filter(|c| ['"', '*'].contains(c))?;
    rest[1..].split(mark).next()
}

/// The DOI's address, if the work has one.
fn doi(work: &str) -> Option<&str> {
    let address = work.split_once("https://doi.org/")?.1;
    address.split(')').next()
}
