//! A repository for GitHub, whose workflow grades a class: the command, the course file with what lies beside it, and the workflow.

use super::beside::Beside;
use raybook::store::{self, StoreError};
#[cfg(unix)]
use std::fs;
use std::path::{Path, PathBuf};

/// Writes it into a new folder. The course key is not in it: the workflow takes it from the repository's secrets.
///
/// # Errors
/// If there is something already, or a file cannot be written.
pub fn repository(
    folder: &Path,
    raybook: Vec<u8>,
    course: Vec<u8>,
    beside: Vec<Beside>,
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
    let mut files: Vec<_> = files
        .map(|(name, bytes)| (PathBuf::from(name), bytes))
        .into();
    let programs = beside.iter().filter(|file| file.runs);
    let programs: Vec<_> = programs.map(|file| folder.join(&file.path)).collect();
    files.extend(beside.into_iter().map(|file| (file.path, file.bytes)));
    store::new_folder(folder, &files)?;
    programs.iter().try_for_each(|path| let_run(path))
}

/// Makes a file a program; git keeps that.
#[cfg(unix)]
fn let_run(path: &Path) -> Result<(), StoreError> {
    use std::os::unix::fs::PermissionsExt;
    fs::set_permissions(path, fs::Permissions::from_mode(0o755))
        .map_err(StoreError::of(path, "make this file a program"))
}

/// Elsewhere no file says that it is a program.
#[cfg(not(unix))]
fn let_run(_: &Path) -> Result<(), StoreError> {
    Ok(())
}
