//! A chapter is complete: binary, pictures, page, tests, rows.

use raybook_chapters::LESSONS;
use raybook_common::project;
use raybook_common::source::{read, rust_files};
use std::collections::BTreeSet;

#[test]
fn every_chapter_has_all_its_parts() {
    let manifest = read("chapters/Cargo.toml");
    let readme = read("README.md");
    let summary = read("book/src/SUMMARY.md");
    for lesson in LESSONS {
        let (name, chapter) = (lesson.name, lesson.chapter());
        let has = |part: bool, what: &str| assert!(part, "{name} lacks {what}");
        has(
            manifest.contains(&format!("name = \"{name}\"\npath = \"{name}/main.rs\"")),
            "a [[bin]] in chapters/Cargo.toml",
        );
        has(
            project("golden").join(name).join("picture.exr").is_file(),
            "golden/<name>/picture.exr: RAYBOOK_BLESS=1 cargo test --test chapters golden",
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
            readme.contains(&format!(
                "| {} | {} | `{name}` |",
                chapter.number(),
                chapter.title
            )),
            "a row in README.md's table",
        );
        has(
            !lesson.teaches().is_empty(),
            "what it teaches, at the top of its file",
        );
    }
    let folders: BTreeSet<_> = rust_files("chapters")
        .filter_map(|(file, _)| Some(file.strip_suffix("/main.rs")?.to_owned()))
        .collect();
    let rows: BTreeSet<_> = LESSONS
        .iter()
        .map(|lesson| lesson.name.to_owned())
        .collect();
    assert_eq!(
        folders, rows,
        "chapters/ and the curriculum must name the same chapters"
    );
}
