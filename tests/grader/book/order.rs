//! Orders in which lessons can be read.

use super::{book, expanded};
use raybook_workbook::curriculum::CHAPTERS;
use std::path::Path;

/// The list of a path.
fn list(path: &str) -> Result<String, String> {
    let book = book(Path::new(""), &[]);
    expanded(&book, "why.md", &format!("{{{{path {path}}}}}"))
}

#[test]
fn the_course_itself_is_a_path() {
    let all: Vec<_> = CHAPTERS.iter().map(|c| c.number().to_string()).collect();
    let path = list(&all.join(" ")).expect("no lesson needs a later one");
    assert_eq!(path.matches("<li").count(), CHAPTERS.len());
}

#[test]
fn a_path_that_cannot_be_read_is_an_error() {
    for (path, said) in [
        ("1 3 12", "chapter 12 (Phong) needs chapter 2"),
        ("1 2 1", "already"),
        ("1 99", "`99` is the number of no chapter"),
        ("1 two", "`two` is the number of no chapter"),
    ] {
        let error = list(path).expect_err("it cannot be read");
        assert!(error.contains(said), "{error}");
    }
}
