//! What the `raybook` command can do, a file for each task.

pub mod asking;
pub mod bless;
pub mod check;
pub mod doctor;
pub mod draw;
pub mod exercise;
pub mod golden;
pub mod hidden;
pub mod hint;
pub mod keep;
pub mod map;
pub mod new;
pub mod render;
pub mod samplers;
pub mod solve;
pub mod tell;
pub mod tour;
pub mod unwritten;

use raybook_grader::cases;
use raybook_grader::examine::Examiner;
use raybook_workbook::curriculum::CHAPTERS;
use std::error::Error;
use std::path::{Path, PathBuf};

/// Whether everything that was asked for is right; else the exit code is 1.
pub type Done = Result<bool, Box<dyn Error>>;

/// Exercises, in the order of the course.
pub type Examiners = Vec<&'static dyn Examiner>;

/// Which folder, and what of it.
#[derive(clap::Args)]
pub struct Target {
    /// A chapter (3, ch03, sphere) or an exercise (sphere_hit), and the student's folder if it is not the present one
    #[arg(value_name = "CHAPTER|EXERCISE|FOLDER")]
    pub what: Vec<String>,
}

impl Target {
    /// The folder, if one was named.
    pub fn folder(&self) -> Option<&str> {
        self.what
            .iter()
            .map(String::as_str)
            .find(|word| exercises_of(word).is_empty() && Path::new(word).is_dir())
    }

    /// The folder, and the exercises in the order of the course.
    ///
    /// # Errors
    /// If a word is neither a folder nor a chapter nor an exercise.
    pub fn resolve(&self) -> Result<(PathBuf, Examiners), Box<dyn Error>> {
        let mut folder = PathBuf::from(".");
        let mut names: Vec<&str> = Vec::new();
        for word in &self.what {
            let of_word = exercises_of(word);
            if !of_word.is_empty() {
                names.extend(of_word);
            } else if PathBuf::from(word).is_dir() {
                folder = PathBuf::from(word);
            } else {
                let all: Vec<_> = cases::all().iter().map(|e| e.name()).collect();
                return Err(format!("`{word}` is neither a chapter, nor an exercise, nor a folder; the exercises are {}", all.join(", ")).into());
            }
        }
        let wanted =
            |examiner: &&dyn Examiner| names.is_empty() || names.contains(&examiner.name());
        Ok((folder, cases::all().into_iter().filter(wanted).collect()))
    }
}

/// The exercises that a word means: of a chapter by number or name, or the one of this name.
fn exercises_of(word: &str) -> Vec<&'static str> {
    let chapter = CHAPTERS.iter().find(|chapter| chapter.answers_to(word));
    let of_chapter = chapter.map(|chapter| {
        chapter
            .exercises()
            .iter()
            .map(|exercise| exercise.name)
            .collect()
    });
    let of_this_name = || cases::find(word).map(<dyn Examiner>::name);
    of_chapter.unwrap_or_else(|| of_this_name().into_iter().collect())
}

/// A word of which something must depend.
fn not_empty(text: &str) -> Result<String, String> {
    if text.trim().is_empty() {
        return Err("it is empty, so that anybody could foresee the hidden cases".to_owned());
    }
    Ok(text.to_owned())
}

/// A time limit in seconds.
fn seconds(text: &str) -> Result<f32, String> {
    text.parse()
        .ok()
        .filter(|&s| s > 0.0 && s <= 3600.0)
        .ok_or_else(|| "a number of seconds, above 0 and at most 3600".to_owned())
}
