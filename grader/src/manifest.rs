//! The manifests of a student's folder, derived from the course's.

use crate::library;

/// The course's own.
const COURSE: &str = include_str!("../../Cargo.toml");

/// The package that stays with the course, but has a profile in its manifest.
const WITHHELD: &str = "raybook-grader";

/// The `Cargo.toml` of the folder: the library, without the features that answering does not need.
pub fn root() -> String {
    let features: String = lines(section(COURSE, "features"))
        .map(|line| match line.strip_prefix("default = ") {
            Some(_) => "default = []",
            None => line,
        })
        .flat_map(|line| [line, "\n"])
        .collect();
    let own = sections(COURSE).filter(|(title, _)| title.ends_with("dependencies"));
    let own = own.filter(|(title, _)| !title.contains("dev-") && !title.starts_with("workspace"));
    let dependencies: String = own.flat_map(written).collect();
    let inherited = [&dependencies, &workbook()].map(String::as_str).concat();
    format!(
        include_str!("starter/Cargo.toml.txt"),
        package = section(COURSE, "workspace.package"),
        shared = shared(&inherited, "."),
        features = features,
        dependencies = dependencies,
    )
}

/// The `workbook/Cargo.toml`: the course's, with the answer program as what is run.
pub fn workbook() -> String {
    let text = library::manifest_of_workbook();
    text.replacen("\n\n", "\ndefault-run = \"answer\"\n\n", 1)
}

/// The `Cargo.toml` of the chapters' package, at `.raybook/chapters`: a workspace of its own, in which the library has all its
/// features.
pub fn chapters() -> String {
    let own = untested(library::manifest_of_chapters());
    let profiles: String = sections(COURSE)
        .filter(|(title, _)| title.starts_with("profile.release") && !title.contains(WITHHELD))
        .flat_map(written)
        .collect();
    format!(
        "[workspace] # of its own: the workbook compiles without it\nresolver = \"3\"\n\n[workspace.package]\n{}\n[workspace.dependencies]\n{}{own}{profiles}",
        section(COURSE, "workspace.package"),
        shared(&[&own[..], &scenes()].concat(), "../.."),
    )
}

/// The `Cargo.toml` of the scene files' package, which the chapters read their scenes with, at `.raybook/chapters/scenes`.
pub fn scenes() -> String {
    untested(library::manifest_of_scenes())
}

/// A package's manifest without what only its tests and lints need.
fn untested(manifest: &str) -> String {
    sections(manifest)
        .filter(|(title, _)| !["dev-dependencies", "[test]", "lints"].contains(title))
        .flat_map(written)
        .collect()
}

/// The dependencies that a manifest inherits, with the library at `folder`.
fn shared(inherited: &str, folder: &str) -> String {
    let features =
        lines(section(COURSE, "features")).find_map(|line| line.strip_prefix("default = "));
    let shared = lines(section(COURSE, "workspace.dependencies")).filter_map(|line| {
        let name = line.split(" = ").next()?;
        let is_used = lines(inherited).any(|line| {
            line.split(['.', ' ']).next() == Some(name) && line.contains("workspace = true")
        });
        is_used.then(|| match name {
            "raybook" if folder == "." => "raybook = { path = \".\" }\n".to_owned(),
            "raybook" => format!(
                "raybook = {{ path = \"{folder}\", features = {} }}\n",
                features.unwrap_or("[]")
            ),
            "raybook-scenes" => "raybook-scenes = { path = \"scenes\" }\n".to_owned(),
            "raybook-workbook" => {
                format!("raybook-workbook = {{ path = \"{folder}/workbook\" }}\n")
            }
            _ => format!("{line}\n"),
        })
    });
    shared.collect()
}

/// The text of a section.
fn section<'a>(manifest: &'a str, title: &str) -> &'a str {
    let found = sections(manifest).find(|(of, _)| *of == title);
    found.map_or("", |(_, text)| text)
}

/// The sections with their titles (`[bin]` for one of several), in order; what a comment says beside a title is left out.
fn sections(manifest: &str) -> impl Iterator<Item = (&str, &str)> {
    let parts = manifest.split("\n[").enumerate();
    parts.filter_map(|(i, part)| {
        let part = if i == 0 {
            part.strip_prefix('[')?
        } else {
            part
        };
        let (header, text) = part.split_once('\n')?;
        let header = header.split(" #").next()?;
        Some((header.strip_suffix(']')?, text))
    })
}

/// A section as it is written, in parts.
fn written<'a>((title, text): (&'a str, &'a str)) -> [&'a str; 4] {
    ["\n[", title, "]\n", text]
}

/// The lines that say something.
fn lines(text: &str) -> impl Iterator<Item = &str> {
    text.lines().filter(|line| !line.trim().is_empty())
}
