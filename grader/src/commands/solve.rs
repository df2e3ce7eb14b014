//! `raybook solve`: the reference for a chapter that a student missed.

use super::{Done, Target};
use raybook::store;
use raybook_chapters::kit::say::say;
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_grader::class::course::Solve as References;
use raybook_grader::class::taken;
use raybook_grader::examine::Examiner;
use raybook_grader::language::Language;
use raybook_grader::lock::Lock;
use raybook_grader::progress::{KEPT, unused};
use raybook_grader::recipe::Recipe;
use raybook_grader::starter::{place, reference_file};
use raybook_grader::{cases, student};
use std::collections::BTreeSet;
use std::error::Error;
use std::io::ErrorKind;
use std::path::Path;

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
        let language = Language::find(recipe.language()).ok_or_else(|| {
            format!(
                "this workbook is in {}, and there are references in Python, C++ and Rust only; `raybook book` has those in Rust, beside their derivations",
                Untrusted::from(recipe.language())
            )
        })?;
        let names = || examiners.iter().map(|examiner| examiner.name());
        let places: BTreeSet<_> = names().filter_map(|name| place(language, name)).collect();
        ask_the_course(&folder)?;
        let _lock = Lock::on(&folder.join(KEPT))?;
        for file in places {
            let reference = reference_file(language, &file)
                .ok_or_else(|| format!("{file} has no reference"))?;
            let path = folder.join(&file);
            match store::read(&path) {
                Ok(yours) if yours == reference.as_bytes() => {
                    say(format!("{file} is the reference already"));
                    continue;
                }
                Ok(yours) => {
                    let kept = unused(&folder.join(KEPT).join("yours").join(&file));
                    store::write(&kept, &yours)?;
                    say(format!(
                        "{file} is now the reference; yours is kept in {}",
                        Untrusted::from(kept.as_path())
                    ));
                }
                Err(error) if error.reason.kind() != ErrorKind::NotFound => {
                    return Err(error.into());
                }
                Err(_) => say(format!("{file} is now the reference")),
            }
            record(&folder, language, &file)?;
            store::write(&path, reference.as_bytes())?;
        }
        Ok(true)
    }
}

/// Whether the course gives references out, where its file lies in the workbook.
///
/// # Errors
/// If it does not.
fn ask_the_course(workbook: &Path) -> Result<(), Box<dyn Error>> {
    let file = workbook.join("course.toml");
    if !file.is_file() || References::read(&file, &store::read_text(&file)?)?.allowed {
        return Ok(());
    }
    let file = Untrusted::from(file.as_path());
    Err(format!("{file}: this course gives no references out; `raybook hint` gives a nudge").into())
}

/// Records that the references in a file are taken. The record is handed in with the workbook.
fn record(workbook: &Path, language: Language, file: &str) -> Result<(), Box<dyn Error>> {
    let path = workbook.join(taken::FILE);
    let text = match store::read_text(&path) {
        Err(error) if error.reason.kind() == ErrorKind::NotFound => String::new(),
        read => read?,
    };
    let names = cases::all().into_iter().map(<dyn Examiner>::name);
    let names: Vec<_> = names
        .filter(|name| place(language, name).as_deref() == Some(file))
        .collect();
    store::write(&path, taken::record(&text, &names).as_bytes())?;
    Ok(())
}
