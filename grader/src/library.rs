//! The library's own text, which the command carries with it: starters and references are taken from it.

use include_dir::{Dir, File, include_dir};
use raybook_workbook::anchor;

static SOURCE: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/../src");
static CHAPTERS: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/../chapters");

/// All files of `src/`, with their paths from there.
pub fn source() -> Vec<&'static File<'static>> {
    all_files(&SOURCE)
}

/// All files of `chapters/`.
pub fn chapters() -> Vec<&'static File<'static>> {
    all_files(&CHAPTERS)
}

/// The file in which a student writes an exercise, as a path in the student's folder.
pub fn place(exercise: &str) -> Option<String> {
    let holds = |file: &&File<'_>| {
        let regions = anchor::regions(file.contents_utf8().unwrap_or_default()).unwrap_or_default();
        regions.iter().any(|(name, _)| *name == exercise)
    };
    let file = source().into_iter().find(holds)?;
    Some(format!(
        "src/{}",
        file.path().to_string_lossy().replace('\\', "/")
    ))
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

/// The reference's whole file, as the starter would have it with nothing left to write.
pub fn reference_file(place: &str) -> Option<String> {
    let text = SOURCE
        .get_file(place.strip_prefix("src/")?)?
        .contents_utf8()?;
    Some(
        text.lines()
            .filter(|line| !is_of_the_course(line))
            .flat_map(|line| [line, "\n"])
            .collect(),
    )
}

/// The lines that mean nothing to the student: the anchors, and in `lib.rs` the grader, which is not there.
pub fn is_of_the_course(line: &str) -> bool {
    let line = line.trim();
    line == "pub mod grade;"
        || line.ends_with("| grade |")
        || line.ends_with("| commands |")
        || line.starts_with("// ANCHOR")
}

fn all_files<'a>(folder: &'a Dir<'static>) -> Vec<&'a File<'static>> {
    let below = folder.dirs().flat_map(all_files);
    folder.files().chain(below).collect()
}
