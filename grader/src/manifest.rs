//! The student's `Cargo.toml`, derived from the course's.

use crate::starter::StarterFile;
use raybook_workbook::curriculum::CHAPTERS;

const MANIFEST: &str = include_str!("../../Cargo.toml");

/// The table of what only Unix systems need.
const UNIX: &str = "target.'cfg(unix)'.dependencies";

/// The student's `Cargo.toml`: the chapters' binaries, and those of the library's dependencies that the copied files use.
pub fn text(files: &[StarterFile]) -> String {
    let sources: Vec<_> = files
        .iter()
        .map(|(_, bytes)| String::from_utf8_lossy(bytes))
        .collect();
    let used = |line: &str| {
        let dependency = line
            .split([' ', '='])
            .next()
            .unwrap_or_default()
            .replace('-', "_");
        sources
            .iter()
            .any(|source| source.contains(&format!("{dependency}::")))
    };
    let section = |title: &str| {
        let rest = MANIFEST
            .split_once(&format!("\n[{title}]\n"))
            .map_or("", |(_, rest)| rest);
        rest.split("\n[").next().unwrap_or_default()
    };
    let dependencies = |title| -> String {
        let lines = section(title).lines().filter(|line| used(line));
        lines.flat_map(|line| [line, "\n"]).collect()
    };
    let bin = |name| format!("[[bin]]\nname = \"{name}\"\npath = \"chapters/{name}.rs\"\n\n");
    let chapters: Vec<_> = CHAPTERS.iter().map(|chapter| bin(chapter.name)).collect();
    format!(
        include_str!("starter/Cargo.toml.txt"),
        dependencies = dependencies("dependencies"),
        unix_dependencies = dependencies(UNIX),
        chapters = chapters.concat()
    )
}
