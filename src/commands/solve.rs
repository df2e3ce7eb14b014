//! `raybook solve`: the reference for a chapter that a student missed.

use super::{Done, Target};
use raybook::grade::{library, student};
use raybook::image::file;
use std::collections::BTreeSet;
use std::fs;

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
            let (path, kept) = (
                folder.join(&place),
                folder.join(".raybook/yours").join(&place),
            );
            match fs::read(&path) {
                Ok(yours) if yours == reference.as_bytes() => {
                    println!("{place} is the reference already");
                    continue;
                }
                Ok(yours) => {
                    file::write_whole(&kept, &yours)?;
                    println!(
                        "{place} is now the reference; yours is kept in {}",
                        kept.display()
                    );
                }
                Err(_) => println!("{place} is now the reference"),
            }
            file::write_whole(&path, reference.as_bytes())?;
        }
        Ok(true)
    }
}
