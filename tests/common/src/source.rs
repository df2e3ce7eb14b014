//! Reading the project's own sources.

use super::project;
use std::collections::BTreeMap;
use std::fs;

/// The first folder of a file's path.
pub fn top_module(file: &str) -> &str {
    file.split('/').next().expect("a path has a first part")
}

/// All Rust files under a folder, with their paths from there and their texts.
pub fn rust_files(folder: &str) -> impl Iterator<Item = (String, String)> {
    let root = project(folder);
    let mut open = vec![root.clone()];
    let mut files = Vec::new();
    while let Some(folder) = open.pop() {
        for entry in fs::read_dir(&folder).into_iter().flatten().flatten() {
            let path = entry.path();
            if path.is_dir() {
                open.push(path);
            } else if path.extension().is_some_and(|e| e == "rs") {
                let name = path
                    .strip_prefix(&root)
                    .expect("it is below")
                    .to_string_lossy()
                    .replace('\\', "/");
                files.push((
                    name,
                    fs::read_to_string(&path).expect("a source file is text"),
                ));
            }
        }
    }
    assert!(
        !files.is_empty() || !root.exists(),
        "{} holds Rust files",
        root.display()
    );
    files.into_iter()
}

/// Every path below `root::` that the code names, with `{a, b::{c}}` taken apart; comments do not count.
pub fn used_paths(text: &str, root: &str) -> Vec<String> {
    let code: String = text
        .lines()
        .map(|line| line.split("//").next().unwrap_or_default())
        .collect::<Vec<_>>()
        .join(" ");
    let prefix = format!("{root}::");
    let starts = code.match_indices(&prefix).map(|(at, _)| at + prefix.len());
    starts.flat_map(|at| expand(&code[at..], "").0).collect()
}

/// Expands one tree of a `use` from the start of the text; also returns how many bytes it took.
fn expand(text: &str, above: &str) -> (Vec<String>, usize) {
    let word = text
        .find(|c: char| !(c.is_alphanumeric() || c == '_' || c == ':'))
        .unwrap_or(text.len());
    let path = format!("{above}{}", &text[..word]);
    if !text[word..].starts_with('{') {
        return (vec![path.trim_end_matches("::self").to_owned()], word);
    }
    let (mut paths, mut at) = (Vec::new(), word + 1);
    loop {
        at += text[at..].len() - text[at..].trim_start_matches([' ', ',']).len();
        if text[at..].is_empty() || text[at..].starts_with('}') {
            return (paths, at + 1);
        }
        let (inner, length) = expand(&text[at..], &path);
        assert!(
            length > 0,
            "cannot read the use of {path} in {:?}",
            &text[..text.len().min(80)]
        );
        paths.extend(inner);
        at += length;
    }
}

/// The file below `src/` in which a path's item stands: the longest beginning that is a file, else the folder's `mod.rs`.
pub fn file_of(path: &str, sources: &BTreeMap<String, String>) -> String {
    let parts: Vec<_> = path.split("::").collect();
    let candidates = (1..=parts.len()).rev().flat_map(|n| {
        let stem = parts[..n].join("/");
        [format!("{stem}.rs"), format!("{stem}/mod.rs")]
    });
    candidates
        .into_iter()
        .find(|file| sources.contains_key(file))
        .unwrap_or_else(|| panic!("no file holds {path}"))
}

/// The text of a file of the project.
pub fn read(path: &str) -> String {
    let path = project(path);
    fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}
