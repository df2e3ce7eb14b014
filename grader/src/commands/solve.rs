//! `raybook solve`: the reference for a chapter that a student missed.

use super::{Done, Target};
use raybook::store;
use raybook_chapters::kit::say::say;
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_grader::lock::Lock;
use raybook_grader::progress::{KEPT, unused};
use raybook_grader::recipe::Recipe;
use raybook_grader::{library, student};
use std::collections::BTreeSet;
use std::io::ErrorKind;

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
        let recipe = Recipe::read(&folder)?;
        if recipe != Recipe::Rust {
            return Err(format!(
                "this workbook is in {}, and the reference is in Rust; it is written into {KEPT} when your chapter is right",
                Untrusted::from(recipe.language())
            )
            .into());
        }
        let places: BTreeSet<_> = examiners
            .iter()
            .filter_map(|examiner| library::place(examiner.name()))
            .collect();
        let _lock = Lock::on(&folder.join(KEPT))?;
        for place in places {
            let reference = library::reference_file(&place)
                .ok_or_else(|| format!("{place} has no reference"))?;
            let path = folder.join(&place);
            match store::read(&path) {
                Ok(yours) if yours == reference.as_bytes() => {
                    say(format!("{place} is the reference already"));
                    continue;
                }
                Ok(yours) => {
                    let kept = unused(&folder.join(KEPT).join("yours").join(&place));
                    store::write(&kept, &yours)?;
                    say(format!(
                        "{place} is now the reference; yours is kept in {}",
                        Untrusted::from(kept.as_path())
                    ));
                }
                Err(error) if error.reason.kind() != ErrorKind::NotFound => {
                    return Err(error.into());
                }
                Err(_) => say(format!("{place} is now the reference")),
            }
            store::write(&path, reference.as_bytes())?;
        }
        Ok(true)
    }
}
