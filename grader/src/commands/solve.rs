//! `raybook solve`: the reference for a chapter that a student missed.

use super::{Done, Target};
use raybook::image::file;
use raybook_chapters::kit::say::say;
use raybook_grader::{library, student};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Copies in the reference; what was there is kept.
#[derive(clap::Args)]
pub struct Solve {
    /// The chapter (3, ch03, sphere), and the student's folder if it is not the present one
    #[command(flatten)]
    target: Target,
}

impl Solve {
    /// Replaces the files in which the exercises are written.
    pub fn run(&self) -> Done {
        let (from, examiners) = self.target.resolve()?;
        let folder = student::workbook(&from)?;
        if self.target.what.is_empty() {
            return Err("which chapter? For example: raybook solve ch03".into());
        }
        let places: BTreeSet<_> = examiners
            .iter()
            .filter_map(|examiner| library::place(examiner.name()))
            .collect();
        for place in places {
            let reference = library::reference_file(&place)
                .ok_or_else(|| format!("{place} has no reference"))?;
            let path = folder.join(&place);
            match fs::read(&path) {
                Ok(yours) if yours == reference.as_bytes() => {
                    say(format!("{place} is the reference already"));
                    continue;
                }
                Ok(yours) => {
                    let kept = unused(&folder.join(".raybook/yours").join(&place));
                    file::write_whole(&kept, &yours)?;
                    say(format!(
                        "{place} is now the reference; yours is kept in {}",
                        kept.display()
                    ));
                }
                Err(_) => say(format!("{place} is now the reference")),
            }
            file::write_whole(&path, reference.as_bytes())?;
        }
        Ok(true)
    }
}

/// The path, or with `.2`, `.3`, … after it the first at which there is nothing yet.
fn unused(path: &Path) -> PathBuf {
    let mut free = path.to_owned();
    let mut number = 1;
    while free.exists() {
        number += 1;
        free = PathBuf::from(format!("{}.{number}", path.display()));
    }
    free
}
