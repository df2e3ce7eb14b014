//! The table of topics and files stands in `src/lib.rs` and in the README, and is true.

use raybook_common::project;
use raybook_common::source::{read, rust_files};
use std::collections::BTreeSet;

/// The lines of the table, without what a line begins with.
fn table(file: &str, before: &str) -> Vec<String> {
    let text = read(file);
    let lines = text.lines().filter_map(|line| line.strip_prefix(before));
    lines
        .skip_while(|line| !line.starts_with("| what | where"))
        .take_while(|line| line.starts_with('|'))
        .map(str::to_owned)
        .collect()
}

#[test]
fn the_readme_has_the_same_table() {
    let here = table("src/lib.rs", "//! ");
    assert!(here.len() > 30, "the test must see the rows: {here:?}");
    assert_eq!(table("README.md", ""), here);
}

#[test]
fn every_file_of_the_table_exists_and_every_module_is_in_it() {
    let rows = table("src/lib.rs", "//! ");
    let files: Vec<_> = rows.iter().skip(2).flat_map(|row| named(row)).collect();
    for file in &files {
        let path = project("src").join(file);
        assert!(path.is_file(), "src/{file} does not exist");
    }
    let top = |file: &str| file.split_once('/').map(|(module, _)| module.to_owned());
    let named: BTreeSet<_> = files.iter().filter_map(|file| top(file)).collect();
    for module in rust_files("src").filter_map(|(file, _)| top(&file)) {
        assert!(named.contains(&module), "where is {module}?");
    }
}

/// The files of a row, which stand between back-ticks.
fn named(row: &str) -> impl Iterator<Item = &str> {
    row.split('`').skip(1).step_by(2)
}
