//! The course's own text, which the command carries with it: starters and references are taken from it.

use include_dir::{Dir, File, include_dir};
use raybook_workbook::anchor::{self, Anchored};
use std::path::Path;

static SOURCE: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/../src");
static WORKBOOK: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/../workbook");
static CHAPTERS: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/../chapters");
static SOLUTIONS: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/../tests/solutions");

/// The example of the library that chapter 19 draws.
pub const MANY_BALLS: &str = include_str!("../../examples/many_balls.rs");

/// What a package's files are called besides its sources.
pub const MANIFEST: &str = "Cargo.toml";

/// All files of the library, with their paths from `src/`.
pub fn source() -> Vec<&'static File<'static>> {
    all_files(&SOURCE)
}

/// All files of the exercises' package, with their paths from its folder.
pub fn workbook() -> Vec<&'static File<'static>> {
    all_files(&WORKBOOK)
}

/// All files of the chapters' package, with their paths from its folder.
pub fn chapters() -> Vec<&'static File<'static>> {
    all_files(&CHAPTERS)
}

/// The manifest of the exercises' package.
pub fn manifest_of_workbook() -> &'static str {
    manifest(&WORKBOOK)
}

/// The manifest of the chapters' package.
pub fn manifest_of_chapters() -> &'static str {
    manifest(&CHAPTERS)
}

/// The manifest of the scene files' package.
pub fn manifest_of_scenes() -> &'static str {
    CHAPTERS.get_dir("scenes").map_or("", manifest)
}

/// The file in which a student writes an exercise, as a path in the student's folder.
pub fn place(exercise: &str) -> Option<String> {
    let holds = |file: &&File<'_>| {
        let regions = anchor::regions(file.contents_utf8().unwrap_or_default()).unwrap_or_default();
        regions.iter().any(|(name, _)| *name == exercise)
    };
    let file = source().into_iter().find(holds)?;
    Some(format!("src/{}", slashes(file)))
}

/// The path with forward slashes, on every system.
pub fn slashes(file: &File<'_>) -> String {
    file.path().to_string_lossy().replace('\\', "/")
}

/// The reference's text of an exercise: the function with its comment.
pub fn reference(exercise: &str) -> Option<&'static str> {
    source().into_iter().find_map(|file| {
        let regions = anchor::regions(file.contents_utf8()?).ok()?;
        regions
            .into_iter()
            .find(|(name, _)| *name == exercise)
            .map(|(_, text)| text)
    })
}

/// The reference's function of an exercise, taken apart.
pub fn function(exercise: &str) -> Option<Anchored<'static>> {
    source().into_iter().find_map(|file| {
        let functions = anchor::functions(file.contents_utf8()?).ok()?;
        functions.into_iter().find(|f| f.name == exercise)
    })
}

/// The reference's whole file, as the starter would have it with nothing left to write.
pub fn reference_file(place: &str) -> Option<String> {
    let text = SOURCE
        .get_file(place.strip_prefix("src/")?)?
        .contents_utf8()?;
    Some(without_anchors(text))
}

/// A chapter's file with all exercises solved, in another language than Rust.
pub fn solution(language: &str, file: &str) -> Option<&'static str> {
    SOLUTIONS
        .get_dir(language)?
        .get_file(Path::new(language).join(file))?
        .contents_utf8()
}

/// The text without the anchors' lines, which mean nothing to the student.
pub fn without_anchors(text: &str) -> String {
    text.lines()
        .filter(|line| !line.trim().starts_with("// ANCHOR"))
        .flat_map(|line| [line, "\n"])
        .collect()
}

fn manifest(folder: &'static Dir<'static>) -> &'static str {
    let file = folder.get_file(folder.path().join(MANIFEST));
    file.and_then(File::contents_utf8).unwrap_or_default()
}

fn all_files<'a>(folder: &'a Dir<'static>) -> Vec<&'a File<'static>> {
    let below = folder.dirs().flat_map(all_files);
    folder.files().chain(below).collect()
}
