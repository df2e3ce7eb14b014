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
use raybook_grader::starter::{place, reference, reference_alone, reference_file};
use raybook_grader::{cases, student};
use std::collections::BTreeSet;
use std::error::Error;
use std::io::ErrorKind;
use std::path::Path;

/// Gives the reference: of a chapter its file, where what was there is kept; of an exercise its function, to be read.
#[derive(clap::Args)]
pub struct Solve {
    /// The chapter (3, ch03, sphere) or exercise (sphere_hit), and the student's folder if it is not the present one
    #[command(flatten)]
    target: Target,
}

impl Solve {
    /// Replaces the files whose exercises are all asked for; of other files, shows the references that are asked for.
    pub fn run(&self) -> Done {
        let (from, examiners) = self.target.resolve()?;
        let folder = student::workbook(&from)?;
        if self.target.what.is_empty() {
            return Err("which chapter or exercise? For example: raybook solve ch03".into());
        }
        let recipe = Recipe::read(&folder)?;
        let language = Language::find(recipe.language()).ok_or_else(|| {
            format!(
                "this workbook is in {}, and there are references in Python, C++ and Rust only; `raybook book` has those in Rust, beside their derivations",
                Untrusted::from(recipe.language())
            )
        })?;
        let names: Vec<_> = examiners.iter().map(|examiner| examiner.name()).collect();
        let is_solved = |name: &&str| reference(language, name).is_some();
        let unsolved: Vec<_> = names
            .iter()
            .copied()
            .filter(|name| !is_solved(name))
            .collect();
        if !unsolved.is_empty() {
            let told = format!(
                "{}: no reference in {} yet; `raybook book` has the one in Rust",
                unsolved.join(", "),
                language.name()
            );
            if unsolved.len() == names.len() {
                return Err(told.into());
            }
            say(told);
        }
        let places = names.iter().filter_map(|name| place(language, name));
        let places: BTreeSet<_> = places.collect();
        ask_the_course(&folder)?;
        let _lock = Lock::on(&folder.join(KEPT))?;
        for file in places {
            let (asked, others): (Vec<_>, Vec<_>) = written_in(language, &file)
                .into_iter()
                .partition(|name| names.contains(name));
            let asked: Vec<_> = asked.into_iter().filter(is_solved).collect();
            if !others.is_empty() {
                record(&folder, &asked)?;
                show(language, &file, &asked, &others);
                continue;
            }
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
            record(&folder, &asked)?;
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

/// The exercises that are written in a file.
fn written_in(language: Language, file: &str) -> Vec<&'static str> {
    let names = cases::all().into_iter().map(<dyn Examiner>::name);
    names
        .filter(|name| place(language, name).as_deref() == Some(file))
        .collect()
}

/// Shows the references of some exercises of a file: to put them there would replace what the student wrote for the others.
fn show(language: Language, file: &str, asked: &[&str], others: &[&str]) {
    for name in asked {
        if let Some(text) = reference_alone(language, name) {
            say(text.trim_end());
        }
    }
    say(format!(
        "\nThis is the reference of {}: copy from it what you need. {file} is as it was, for it has your {} too.",
        asked.join(", "),
        others.join(", ")
    ));
}

/// Records that references are taken. The record is handed in with the workbook.
fn record(workbook: &Path, names: &[&str]) -> Result<(), Box<dyn Error>> {
    let path = workbook.join(taken::FILE);
    let text = match store::read_text(&path) {
        Err(error) if error.reason.kind() == ErrorKind::NotFound => String::new(),
        read => read?,
    };
    store::write(&path, taken::record(&text, names).as_bytes())?;
    Ok(())
}
