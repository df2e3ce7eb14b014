//! The book: every listing is a whole anchor of a file that exists, because mdBook passes a missing one in silence. What a lesson
//! must have, and the course's own directives, are tested with the grader, which expands them.

use raybook_common::project;
use std::fs;

#[test]
fn every_listing_is_an_anchor_that_exists() {
    let mut listings = 0;
    for (page, text) in pages() {
        for (number, line) in (1..).zip(text.lines()) {
            let at = format!("book/src/{page}:{number}");
            for part in line.split("{{").skip(1) {
                let (inside, _) = part
                    .split_once("}}")
                    .unwrap_or_else(|| panic!("{at}: {{{{ is not closed"));
                if !inside.starts_with('#') {
                    continue; // the course's own
                }
                let target = inside
                    .strip_prefix("#include ")
                    .unwrap_or_else(|| panic!("{at}: only #include, not {inside}"));
                let (file, anchor) = target
                    .split_once(':')
                    .unwrap_or_else(|| panic!("{at}: {target} lacks an anchor"));
                let path = project("book/src").join(file);
                let source = fs::read_to_string(&path)
                    .unwrap_or_else(|e| panic!("{at}: {}: {e}", path.display()));
                let listing =
                    anchored(&source, anchor).unwrap_or_else(|why| panic!("{at}: {file}: {why}"));
                assert!(
                    listing.contains("fn ")
                        || listing.contains("struct ")
                        || listing.contains("trait "),
                    "{at}: {anchor} is not a whole item"
                );
                listings += 1;
            }
        }
    }
    assert!(
        listings >= 15,
        "the test must see the listings; it saw {listings}"
    );
}

#[test]
fn no_listing_is_typed_by_hand() {
    for (page, text) in pages() {
        let mut fence: Option<&str> = None;
        for (number, line) in (1..).zip(text.lines()) {
            match (fence, line.strip_prefix("```")) {
                (None, Some(language)) => fence = Some(language),
                (Some(_), Some(_)) => fence = None,
                (Some(language), None) => assert!(
                    !language.starts_with("rust") || line.starts_with("{{#include "),
                    "book/src/{page}:{number}: Rust listings come from the library by {{{{#include}}}}: {line}"
                ),
                (None, None) => {}
            }
        }
        assert!(fence.is_none(), "book/src/{page}: a ``` is not closed");
    }
}

#[test]
fn every_page_that_is_no_lesson_yet_has_its_sections_and_its_picture() {
    for chapter in raybook_workbook::curriculum::CHAPTERS {
        let path = project("book/src").join(chapter.name).with_extension("md");
        let text = fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        if text.contains("\n## Your turn\n") {
            continue; // tests/grader/lesson.rs says what a lesson has
        }
        for part in [
            "## Common mistakes",
            "## Questions",
            "$$",
            "{{#include ",
            &format!("pictures/{}/picture.png", chapter.name),
            &format!("cargo run --release --bin {}", chapter.name),
        ] {
            assert!(
                text.contains(part),
                "{}: there is no {part}",
                path.display()
            );
        }
    }
}

#[test]
fn a_missing_or_broken_anchor_is_noticed() {
    let source = "// ANCHOR: a\nfn a() {}\n// ANCHOR_END: a\n// ANCHOR: b\nfn b() {}\n";
    assert_eq!(
        anchored(source, "a").as_deref(),
        Ok("fn a() {}"),
        "a whole anchor is its lines"
    );
    assert!(anchored(source, "b").is_err(), "b has no end");
    assert!(anchored(source, "c").is_err(), "there is no c");
    assert!(anchored(&source.repeat(2), "a").is_err(), "a stands twice");
}

/// The lines between an anchor's two marks; the marks must each be there once, in order.
fn anchored(source: &str, anchor: &str) -> Result<String, String> {
    let place = |mark: String| {
        let lines: Vec<_> = source
            .lines()
            .enumerate()
            .filter(|(_, line)| line.trim() == mark)
            .map(|(i, _)| i)
            .collect();
        match lines[..] {
            [line] => Ok(line),
            _ => Err(format!("`{mark}` stands there {} times", lines.len())),
        }
    };
    let (start, end) = (
        place(format!("// ANCHOR: {anchor}"))?,
        place(format!("// ANCHOR_END: {anchor}"))?,
    );
    let lines: Vec<_> = source
        .lines()
        .skip(start + 1)
        .take(end.saturating_sub(start + 1))
        .collect();
    if lines.is_empty() {
        Err(format!("{anchor} is empty"))
    } else {
        Ok(lines.join("\n"))
    }
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
    assert!(pages.len() > 5, "the book has pages");
    pages
}
