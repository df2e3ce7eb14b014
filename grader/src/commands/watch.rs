//! `raybook watch`: checks again what a saved file changed.

use super::check::Check;
use super::{Done, Target};
use clap::Parser;
use raybook_chapters::kit::chapter::report;
use raybook_chapters::kit::say::say;
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_grader::progress::Progress;
use raybook_grader::student;
use raybook_grader::watched::{Seen, changed};
use raybook_workbook::curriculum::{CHAPTERS, Chapter};
use std::error::Error;
use std::path::{Path, PathBuf};
use std::thread::sleep;
use std::time::Duration;

/// How often the files are looked at, and how long they must stay the same after a save.
const PAUSE: Duration = Duration::from_millis(250);

/// Watches the workbook: whenever you save a file, checks what it changed, until you press Ctrl-C.
#[derive(clap::Args)]
pub struct Watch {
    #[command(flatten)]
    target: Target,
    /// No colours and no symbols in front of words
    #[arg(long)]
    plain: bool,
}

/// The words of `raybook check`, as they are typed.
#[derive(Parser)]
struct Line {
    #[command(flatten)]
    check: Check,
}

impl Watch {
    /// Checks, and checks again, until the command is interrupted.
    pub fn run(&self) -> Done {
        let (from, _) = self.target.resolve()?;
        let folder = student::workbook(&from)?;
        let mut seen = Seen::of(&folder);
        self.check(&folder, &[])?;
        loop {
            sleep(PAUSE);
            let now = Seen::of(&folder);
            let files = changed(&seen, &now);
            if files.is_empty() {
                continue;
            }
            // Editors write a file in several steps, and people save several files: all of it is one change.
            sleep(PAUSE);
            let later = Seen::of(&folder);
            if !changed(&now, &later).is_empty() {
                continue;
            }
            seen = later;
            say(format!("\n── {} changed ──", told(&files)));
            self.check(&folder, &files)?;
        }
    }

    /// Checks what these files changed. What is wrong with the program is told, and does not end the watch.
    fn check(&self, folder: &Path, files: &[PathBuf]) -> Result<(), Box<dyn Error>> {
        let names = self.names(folder, files);
        let mut words = vec!["check".to_owned()];
        words.extend(names);
        words.extend(self.plain.then(|| "--plain".to_owned()));
        // Words of the command's own, but for the folder, which stands last as a path of its own.
        let line = words.into_iter().map(Into::into);
        let line = line.chain([folder.as_os_str().to_owned()]);
        let line = Line::try_parse_from(line)?;
        if let Err(error) = line.check.run() {
            report(&*error);
        }
        say("\nSave a file to check again; Ctrl-C ends.");
        Ok(())
    }

    /// What to check: what was asked for; else the chapters of the files; else the first chapter that is not right yet.
    fn names(&self, folder: &Path, files: &[PathBuf]) -> Vec<String> {
        let asked = self.target.what.iter().map(String::as_str);
        let asked = asked.filter(|word| Some(*word) != self.target.folder());
        let asked: Vec<_> = asked.map(str::to_owned).collect();
        if !asked.is_empty() {
            return asked;
        }
        let is_changed = |chapter: &&Chapter| {
            let mut places = chapter.exercises().iter();
            places.any(|exercise| {
                let place = student::place(folder, exercise.name);
                place.is_some_and(|place| files.iter().any(|file| file == Path::new(&place)))
            })
        };
        let mut chapters: Vec<_> = CHAPTERS.iter().filter(is_changed).collect();
        if chapters.is_empty() {
            let progress = Progress::load(folder).unwrap_or_default();
            let is_done = |chapter: &Chapter| {
                let mut exercises = chapter.exercises().iter();
                exercises.all(|exercise| progress.is_right(exercise.name))
            };
            chapters.extend(CHAPTERS.iter().find(|chapter| !is_done(chapter)));
        }
        chapters
            .into_iter()
            .map(|chapter| chapter.name.to_owned())
            .collect()
    }
}

/// Some names of files.
fn told(files: &[PathBuf]) -> String {
    const MOST: usize = 3;
    let names = files.iter().take(MOST);
    let names: Vec<_> = names
        .map(|file| Untrusted::from(file.as_path()).to_string())
        .collect();
    let more = files.len().saturating_sub(MOST);
    match more {
        0 => names.join(", "),
        more => format!("{} and {more} more", names.join(", ")),
    }
}
