//! The bibliography: all that lessons recommend, with the same title, and found at the same place.

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
            assert_eq!(found_at(&work), found_at(entry), "“{title}” in {name}");
            assert!(
                entry.contains(&format!("]({name})")),
                "book/src/bibliography.md: “{title}” is recommended in {name} too"
            );
            compared += 1;
        }
    }
    assert!(compared > 90, "{compared} recommendations were compared");
}

#[test]
fn every_work_can_be_found() {
    for entry in page("bibliography.md").lines() {
        let Some(work) = entry.strip_prefix("- ") else {
            continue;
        };
        assert!(
            found_at(work).is_some(),
            "book/src/bibliography.md: where is this found? Give its DOI, its ISBN or an address: {work}"
        );
    }
}

#[test]
fn a_work_without_a_place_is_noticed() {
    for (work, place) in [
        (
            "A. B., 1986: \"C\", *D*, [doi:10.1/2](https://doi.org/10.1/2). In [E](e.md).",
            Some("https://doi.org/10.1/2"),
        ),
        (
            "A. B., 1986: *C*, [e.org](http://e.org/c). In [E](e.md).",
            Some("http://e.org/c"),
        ),
        (
            "A. B., 1986: *C*, ISBN 978-0-12-286160-4. In [E](e.md).",
            Some("978-0-12-286160-4"),
        ),
        ("A. B., 1986: *C*, PhD thesis. In [E](e.md).", None),
    ] {
        assert_eq!(found_at(work), place, "{work}");
    }
}

#[test]
fn a_citation_stands_on_one_line() {
    // What is broken over two lines does not become a link.
    let bibliography = page("bibliography.md");
    let works = bibliography.lines().filter_map(|line| {
        let (authors, _) = line.strip_prefix("- ")?.split_once(": ")?;
        let (authors, year) = authors.rsplit_once(", ")?;
        Some((authors.rsplit(' ').next()?, year))
    });
    let works: Vec<_> = works.collect();
    for (name, text) in pages() {
        let lines: Vec<_> = text.lines().collect();
        for pair in lines.windows(2) {
            let below = pair[1].trim_start_matches('(');
            let broken = works
                .iter()
                .find(|(author, year)| pair[0].ends_with(author) && below.starts_with(year));
            assert!(
                broken.is_none(),
                "book/src/{name}: write the year on the line of the author: {} {}",
                pair[0],
                pair[1]
            );
        }
    }
}

/// The title of a work: the first part in quotation marks or in italics after the year.
fn title(work: &str) -> Option<&str> {
    let rest = work.split_once(": ")?.1;
    let mark = rest.chars().next().filter(|c| ['"', '*'].contains(c))?;
    rest[1..].split(mark).next()
}

/// Where a work is found: the address of its DOI or of a page, or the ISBN of its book.
fn found_at(work: &str) -> Option<&str> {
    let address = work.split("](").skip(1).find(|to| to.starts_with("http"));
    if let Some(address) = address {
        return address.split(')').next();
    }
    let isbn = work.split_once("ISBN ")?.1;
    isbn.split(['.', ' ']).next()
}
