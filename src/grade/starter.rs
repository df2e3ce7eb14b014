//! The student's folder: a copy of the library in which the exercises are still to be written.

use crate::grade::cases;
use crate::image::file;
use crate::workbook::anchor::{self, AnchorError, Anchored};
use include_dir::{Dir, include_dir};
use std::io;
use std::path::{Path, PathBuf};

static SOURCE: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/src");
static CHAPTERS: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/chapters");
const MANIFEST: &str = include_str!("../../Cargo.toml");
const LOCK: &str = include_str!("../../Cargo.lock");

/// What stays with the course: the grader, and the `raybook` command.
const WITHHELD: &[&str] = &["grade", "main.rs", "commands"];

/// The file by which a student's folder is known.
pub const MARKER: &str = "raybook.toml";

/// A file of the starter: its path in the student's folder, and its bytes.
pub type StarterFile = (PathBuf, Vec<u8>);

/// Why a folder cannot be made.
#[derive(Debug, thiserror::Error)]
pub enum StarterError {
    /// There is something already.
    #[error("{}: this folder is not empty; choose a new name", .0.display())]
    Exists(PathBuf),
    /// The system refused.
    #[error("{}: cannot write this file: {source}", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// The system's answer.
        source: io::Error,
    },
    /// The library itself is wrong; a test sees to it that it is not.
    #[error("src/{0}: {1}")]
    Anchor(String, AnchorError),
}

/// Makes a student's folder.
///
/// # Errors
/// If there is something already, or a file cannot be written.
pub fn create(folder: &Path) -> Result<(), StarterError> {
    if folder
        .read_dir()
        .is_ok_and(|mut entries| entries.next().is_some())
        || folder.is_file()
    {
        return Err(StarterError::Exists(folder.to_owned()));
    }
    let name = folder.file_name().unwrap_or_default().to_string_lossy();
    for (path, bytes) in files(&package_name(&name), &stub)? {
        let path = folder.join(path);
        file::write_whole(&path, &bytes).map_err(|source| StarterError::Write { path, source })?;
    }
    Ok(())
}

/// The student's version of an anchored function: its task, its signature, and `todo!`; `None` if it is no exercise.
pub fn stub(function: &Anchored<'_>) -> Option<String> {
    let task = cases::find(function.name)?.task();
    let indent =
        &function.signature[..function.signature.len() - function.signature.trim_start().len()];
    Some(format!(
        "{indent}/// {task}\n{} {{\n{indent}    todo!(\"{}\")\n{indent}}}\n{indent}",
        function.signature, function.name
    ))
}

/// All files of a starter; `rewrite` gives the anchored functions their new text.
///
/// # Errors
/// If an anchor in the library is wrong.
pub fn files(
    name: &str,
    rewrite: &dyn Fn(&Anchored<'_>) -> Option<String>,
) -> Result<Vec<StarterFile>, StarterError> {
    let mut files = Vec::new();
    for file in all_files(&SOURCE) {
        let path = file.path().to_string_lossy().replace('\\', "/");
        if WITHHELD
            .iter()
            .any(|withheld| path.split('/').next() == Some(*withheld))
        {
            continue;
        }
        let bytes = match file.contents_utf8() {
            Some(text) if path.ends_with(".rs") => {
                let text = anchor::rewrite(text, rewrite)
                    .map_err(|error| StarterError::Anchor(path.clone(), error))?;
                text.lines()
                    .filter(|line| !of_the_course(line))
                    .flat_map(|line| [line, "\n"])
                    .collect::<String>()
                    .into_bytes()
            }
            _ => file.contents().to_vec(),
        };
        files.push((Path::new("src").join(path), bytes));
    }
    for file in all_files(&CHAPTERS) {
        files.push((
            Path::new("chapters").join(file.path()),
            file.contents().to_vec(),
        ));
    }
    let manifest = manifest(name, &files);
    for (path, text) in [
        ("Cargo.toml", manifest.as_str()),
        ("Cargo.lock", LOCK),
        ("src/bin/answer.rs", include_str!("starter/answer.rs.txt")),
        ("README.md", include_str!("starter/README.md")),
        (
            MARKER,
            "# This folder is a raybook workbook: `raybook check` grades it.\nlanguage = \"rust\"\n",
        ),
        (".gitignore", "/target\n/out\n/.raybook\n"),
    ] {
        files.push((PathBuf::from(path), text.as_bytes().to_vec()));
    }
    Ok(files)
}

/// The lines that mean nothing to the student: the anchors, and in `lib.rs` the grader, which is not there.
fn of_the_course(line: &str) -> bool {
    let line = line.trim();
    line == "pub mod grade;" || line.ends_with("| grade |") || line.starts_with("// ANCHOR")
}

/// The file in which a student writes an exercise, as a path in the student's folder.
pub fn place(exercise: &str) -> Option<String> {
    let holds = |file: &&include_dir::File<'_>| {
        let regions = anchor::regions(file.contents_utf8().unwrap_or_default()).unwrap_or_default();
        regions.iter().any(|(name, _)| *name == exercise)
    };
    let file = all_files(&SOURCE).into_iter().find(holds)?;
    Some(format!(
        "src/{}",
        file.path().to_string_lossy().replace('\\', "/")
    ))
}

/// The reference's text of an exercise: the function with its comment.
pub fn reference(exercise: &str) -> Option<&'static str> {
    all_files(&SOURCE).into_iter().find_map(|file| {
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
            .filter(|line| !of_the_course(line))
            .flat_map(|line| [line, "\n"])
            .collect(),
    )
}

fn all_files<'a>(folder: &'a Dir<'static>) -> Vec<&'a include_dir::File<'static>> {
    let below = folder.dirs().flat_map(all_files);
    folder.files().chain(below).collect()
}

/// The folder's name as cargo allows it for a package: letters, digits, `-` and `_`, not a digit first.
fn package_name(folder: &str) -> String {
    let allowed: String = folder
        .chars()
        .map(|c| {
            if c.is_ascii_alphanumeric() || c == '_' {
                c
            } else {
                '-'
            }
        })
        .collect();
    if allowed.starts_with(|c: char| c.is_ascii_alphabetic()) {
        allowed
    } else {
        format!("rays-{allowed}")
    }
}

/// The student's `Cargo.toml`: the chapters' binaries, and those of the library's dependencies that the copied files use.
fn manifest(name: &str, files: &[StarterFile]) -> String {
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
    let dependencies: String = section("dependencies")
        .lines()
        .filter(|line| used(line))
        .flat_map(|line| [line, "\n"])
        .collect();
    let chapters: String = crate::workbook::curriculum::CHAPTERS
        .iter()
        .map(|chapter| {
            format!(
                "[[bin]]\nname = \"{0}\"\npath = \"chapters/{0}.rs\"\n\n",
                chapter.name
            )
        })
        .collect();
    format!(
        include_str!("starter/Cargo.toml.txt"),
        name = name,
        dependencies = dependencies,
        chapters = chapters
    )
}
