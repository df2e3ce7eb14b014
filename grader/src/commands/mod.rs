//! What the `raybook` command can do, a file for each task.

pub mod asking;
pub mod bless;
pub mod book;
pub mod browser;
pub mod check;
pub mod course;
pub mod doctor;
pub mod draw;
pub mod draw_asked;
pub mod exercise;
pub mod expand;
pub mod explain;
pub mod golden;
pub mod grade;
pub mod hidden;
pub mod hint;
pub mod keep;
pub mod manner;
pub mod map;
pub mod new;
pub mod next;
pub mod one_chapter;
pub mod pace;
pub mod pack;
pub mod picture;
pub mod present;
pub mod regrade;
pub mod render;
pub mod report;
pub mod samplers;
pub mod solve;
pub mod tell;
pub mod unwritten;
pub mod watch;

use raybook_chapters::kit::say::complain;
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_grader::cases;
use raybook_grader::examine::Examiner;
use raybook_grader::starter::MARKER;
use raybook_workbook::curriculum::{self, CHAPTERS, Chapter};
use std::error::Error;
use std::path::{Path, PathBuf};

/// Whether everything that was asked for is right; else the exit code is 1.
pub type Done = Result<bool, Box<dyn Error>>;

/// Exercises, in the order of the course.
pub type Examiners = Vec<&'static dyn Examiner>;

/// Which folder, and what of it.
#[derive(clap::Args)]
pub struct Target {
    /// An exercise (sphere_hit) or a chapter (3, ch03, sphere; `chapter phong`, for phong is an exercise too), and the student's folder if it is not the present one; a workbook that is called as a chapter is (`rays`) is meant before it
    #[arg(value_name = "CHAPTER|EXERCISE|FOLDER")]
    pub what: Vec<String>,
}

impl Target {
    /// The folder, if one was named.
    pub fn folder(&self) -> Option<&str> {
        let mut words = self.what.iter();
        let mut found = None;
        while let Some(word) = words.next() {
            if word == "chapter" {
                words.next(); // its name, whatever folder is called so
            } else if is_folder(word) {
                found = Some(word.as_str());
            }
        }
        found
    }

    /// The folder, and the exercises in the order of the course.
    ///
    /// # Errors
    /// If a word is neither a folder nor a chapter nor an exercise.
    pub fn resolve(&self) -> Result<(PathBuf, Examiners), Box<dyn Error>> {
        let names = exercises(&self.what)?;
        let wanted =
            |examiner: &&dyn Examiner| names.is_empty() || names.contains(&examiner.name());
        let folder = PathBuf::from(self.folder().unwrap_or("."));
        Ok((folder, cases::all().into_iter().filter(wanted).collect()))
    }
}

/// Whether a word means a folder: a workbook, even one that is called as a chapter is (`raybook new rays`), or a folder that is not.
fn is_folder(word: &str) -> bool {
    let path = Path::new(word);
    path.join(MARKER).is_file() || (path.is_dir() && exercises_of(word).is_empty())
}

/// The exercises that words mean; folders among them mean none.
fn exercises(words: &[String]) -> Result<Vec<&'static str>, String> {
    let mut names = Vec::new();
    let mut words = words.iter();
    while let Some(word) = words.next() {
        // `chapter phong` is the chapter, where `phong` is the exercise of this name.
        let (word, found) = match word.as_str() {
            "chapter" => {
                let word = words.next();
                let word = word.ok_or("which chapter? For example: chapter phong")?;
                (word, of_chapter(word).unwrap_or_default())
            }
            name if is_folder(name) => continue,
            name => (word, exercises_of(name)),
        };
        if found.is_empty() {
            return Err(unknown(word));
        }
        names.extend(found);
    }
    Ok(names)
}

/// The exercises that a word means: the one of this name, or those of a chapter by number or name.
fn exercises_of(word: &str) -> Vec<&'static str> {
    match cases::find(word) {
        Some(examiner) => vec![examiner.name()],
        None => of_chapter(word).unwrap_or_default(),
    }
}

/// The exercises of a chapter by number or name.
fn of_chapter(word: &str) -> Option<Vec<&'static str>> {
    let chapter = curriculum::called(word)?;
    Some(chapter.exercises().iter().map(|e| e.name).collect())
}

/// The chapter that a word means.
fn chapter(word: &str) -> Result<&'static Chapter, String> {
    curriculum::called(word).ok_or_else(|| {
        let names: Vec<_> = CHAPTERS.iter().map(|chapter| chapter.name).collect();
        let word = Untrusted::from(word);
        format!(
            "{word}: no chapter is called so; there are {}",
            names.join(", ")
        )
    })
}

/// What to say of a word that means nothing.
fn unknown(word: &str) -> String {
    /// Words that are less alike are no slip of the fingers.
    const ALIKE: f64 = 0.85;
    let shown = Untrusted::from(word);
    let exercises = cases::all().into_iter().map(<dyn Examiner>::name);
    let chapters = CHAPTERS.iter().map(|chapter| chapter.name);
    let alike = |name: &'static str| (strsim::jaro_winkler(word, name), name);
    let best = exercises.chain(chapters).map(alike);
    let best = best.max_by(|a, b| a.0.total_cmp(&b.0));
    match best.filter(|(how, _)| *how > ALIKE) {
        Some((_, name)) => format!(
            "`{shown}` is neither a chapter, nor an exercise, nor a folder; did you mean {name}?"
        ),
        None => format!(
            "`{shown}` is neither a chapter, nor an exercise, nor a folder; `raybook exercise` lists them all"
        ),
    }
}

/// How this command was called, if cargo runs it: who does so may have no `raybook` to call by its name.
fn by_cargo() -> Option<&'static str> {
    std::env::var_os("CARGO").map(|_| "cargo run --release --")
}

/// Says which folder is made for a file, where there is none: its name may be misspelt.
fn tell_new_folder(file: &Path) {
    let folder = file
        .parent()
        .filter(|folder| !folder.as_os_str().is_empty());
    if let Some(folder) = folder.filter(|folder| !folder.exists()) {
        let folder = Untrusted::from(folder);
        complain(format!("note: there is no folder {folder}; it is made"));
    }
}

/// A time limit in seconds.
fn seconds(text: &str) -> Result<f32, String> {
    text.parse()
        .ok()
        .filter(|&s| s > 0.0 && s <= 3600.0)
        .ok_or_else(|| "a number of seconds, above 0 and at most 3600".to_owned())
}
