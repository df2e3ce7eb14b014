//! A repository for GitHub, whose workflow grades a class: the command, the course file, and the workflow.

use raybook::store::{self, StoreError};
use std::path::{Path, PathBuf};

/// Writes it into a new folder. The course key is not in it: the workflow takes it from the repository's secrets.
///
/// # Errors
/// If there is something already, or a file cannot be written.
pub fn repository(
    folder: &Path,
    raybook: Vec<u8>,
    course: Vec<u8>,
    parts: u32,
) -> Result<(), StoreError> {
    let numbers: Vec<_> = (1..=parts).map(|part| part.to_string()).collect();
    let workflow = include_str!("github/grade.yml")
        .replace("@NUMBERS", &numbers.join(", "))
        .replace("@PARTS", &parts.to_string());
    let files = [
        (".github/workflows/grade.yml", workflow.into_bytes()),
        ("raybook", raybook),
        ("course.toml", course),
        (
            "hand-ins/.gitignore",
            b"# A folder, an archive or a program of each student belongs here.\n".to_vec(),
        ),
    ];
    let files = files.map(|(name, bytes)| (PathBuf::from(name), bytes));
    store::new_folder(folder, &files)
}
