//! What is packed with a course file: the folders of the instructor's own exercises, which lie beside it.

use super::super::course::Course;
use crate::own;
use raybook_chapters::kit::untrusted::Untrusted;
use std::fs;
use std::path::{Component, Path, PathBuf};

/// A file of such a folder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Beside {
    /// Its path, beside the course file.
    pub path: PathBuf,
    /// Its bytes.
    pub bytes: Vec<u8>,
    /// Whether it is a program.
    pub runs: bool,
}

/// Names that mean something else where a course is packed.
const TAKEN: [&str; 8] = [
    ".git",
    ".github",
    "course.key",
    "course.toml",
    "hand-ins",
    "raybook",
    "run_autograder",
    "setup.sh",
];

/// The files of the folders of own exercises of a course.
///
/// # Errors
/// If a folder does not lie beside the course file, or one of its files cannot be read.
pub fn beside(course: &Course, file: &Path) -> Result<Vec<Beside>, String> {
    let parent = file.parent().unwrap_or(Path::new(""));
    let mut packed = Vec::new();
    for folder in &course.own.folders {
        let path = folder
            .strip_prefix(parent)
            .ok()
            .filter(|path| is_below(path));
        let Some(path) = path else {
            return Err(format!(
                "{}: the folder {} of your own exercises is packed only if it lies beside this file, under a name that is none of {}",
                Untrusted::from(file),
                Untrusted::from(folder.as_path()),
                TAKEN.join(", ")
            ));
        };
        for (name, bytes) in own::files(folder)? {
            let there = folder.join(&name);
            let kind = fs::metadata(&there)
                .map_err(|error| format!("{}: {error}", Untrusted::from(there.as_path())))?;
            packed.push(Beside {
                path: path.join(name),
                bytes,
                runs: runs(&kind),
            });
        }
    }
    Ok(packed)
}

/// Whether a path leads from a folder to one below it that has a name of its own.
fn is_below(path: &Path) -> bool {
    let first = path.iter().next().and_then(|name| name.to_str());
    first.is_some_and(|first| !TAKEN.contains(&first))
        && path
            .components()
            .all(|part| matches!(part, Component::Normal(_)))
}

#[cfg(unix)]
fn runs(kind: &fs::Metadata) -> bool {
    use std::os::unix::fs::PermissionsExt;
    kind.permissions().mode() & 0o100 != 0
}

/// Elsewhere no file says that it is a program.
#[cfg(not(unix))]
fn runs(_: &fs::Metadata) -> bool {
    false
}
