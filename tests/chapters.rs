//! A chapter is complete: binary, pictures, page, tests, rows.

mod common;

use common::project;
use common::source::{read, rust_files};
use raybook::workbook::curriculum::CHAPTERS;
use std::collections::BTreeSet;

#[test]
fn every_chapter_has_all_its_parts() {
    let manifest = read("Cargo.toml");
    let readme = read("README.md");
    let summary = read("book/src/SUMMARY.md");
    let tour = read("src/commands/tour.rs");
    for chapter in CHAPTERS {
        let name = chapter.name;
        let has = |part: bool, what: &str| assert!(part, "{name} lacks {what}");
        has(
            manifest.contains(&format!("name = \"{name}\"\npath = \"chapters/{name}.rs\"")),
            "a [[bin]] in Cargo.toml",
        );
        has(
            tour.contains(&format!("\"{name}\",")),
            "a line in src/commands/tour.rs",
        );
        has(
            project("golden").join(name).join("picture.exr").is_file(),
            "golden/<name>/picture.exr",
        );
        has(
            project("book/src")
                .join(name)
                .with_extension("md")
                .is_file(),
            "a page in book/src",
        );
        has(
            summary.contains(&format!("({name}.md)")),
            "a line in book/src/SUMMARY.md",
        );
        has(
            project("tests").join(name).with_extension("rs").is_file(),
            "a file of tests",
        );
        has(
            readme.contains(&format!(
                "| {} | {} | `{name}` |",
                chapter.number(),
                chapter.title()
            )),
            "a row in README.md's table",
        );
        has(
            !chapter.title().is_empty() && !chapter.teaches().is_empty(),
            "a title and what it teaches, at the top of its file",
        );
        let lines = chapter.source.lines().count();
        has(
            (40..=90).contains(&lines),
            &format!("brevity or substance: 40 to 90 lines, not {lines}"),
        );
    }
    let files: BTreeSet<_> = rust_files("chapters").map(|(file, _)| file).collect();
    let rows: BTreeSet<_> = CHAPTERS
        .iter()
        .map(|chapter| format!("{}.rs", chapter.name))
        .collect();
    assert_eq!(
        files, rows,
        "chapters/ and the curriculum must name the same chapters"
    );
}
