//! The bibliography: all that lessons recommend, with the same title, and found at the same place.

use super::{page, pages};
use raybook_common::source::rust_files;

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

/// Years of the library's comments that name no work: standards and laws.
const NO_WORK: [(&str, &str); 3] = [
    ("image/spectrum.rs", "1931"),
    ("scene/cornell.rs", "1931"),
    ("light/black_body.rs", "1900"),
];

#[test]
fn what_the_library_cites_is_in_the_bibliography() {
    let bibliography = page("bibliography.md");
    let works = bibliography.lines().filter_map(|line| {
        let (made, _) = line.strip_prefix("- ")?.split_once(": ")?;
        made.rsplit_once(", ")
    });
    let works: Vec<_> = works.collect();
    let known = |names: &[&str], year: &str| {
        let of_year = works.iter().filter(|(_, of)| *of == year);
        of_year
            .flat_map(|(authors, _)| authors.split([' ', ',']))
            .any(|author| names.contains(&author))
    };
    let mut cited = 0;
    for (file, source) in rust_files("src") {
        let comments = source
            .lines()
            .filter_map(|line| line.trim_start().strip_prefix("//"));
        let text: String = comments
            .flat_map(|line| [line.trim_start_matches(['/', '!']), " "])
            .collect();
        for (place, year) in years(&text) {
            if NO_WORK.contains(&(file.as_str(), year)) {
                continue;
            }
            // The names stand before the year, and perhaps a title in quotation marks, in which may be parentheses.
            let before = text[..place].trim_end_matches([' ', ',', '(']);
            let quoted = before.strip_suffix('"');
            let names = quoted.and_then(|quoted| quoted.rsplit_once('"'));
            let part = names
                .map_or(before, |(names, _)| names)
                .rsplit(['(', ';'])
                .find(|part| !part.trim().is_empty());
            let names = part.unwrap_or_default().split('"').step_by(2);
            let names: Vec<_> = names
                .flat_map(|names| names.split([' ', ',']))
                .map(|name| name.trim_end_matches("'s"))
                .filter(|name| name.starts_with(char::is_uppercase))
                .collect();
            if names.is_empty() {
                continue;
            }
            assert!(
                known(&names, year),
                "book/src/bibliography.md lacks a work of {year} that src/{file} names: {names:?}; one without a lesson stands under \"Further works that the library names\""
            );
            cited += 1;
        }
    }
    assert!(cited > 110, "{cited} citations were looked up");
}

/// The years from 1600 to 2099 in a text, with their places.
fn years(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let words = text.split(|c: char| !c.is_alphanumeric() && c != '.');
    let years = words.map(|word| word.trim_end_matches('.')).filter(|word| {
        let year = word
            .parse::<u32>()
            .is_ok_and(|year| (1600..2100).contains(&year));
        word.len() == 4 && year
    });
    years.map(|year| (year.as_ptr() as usize - text.as_ptr() as usize, year))
}
