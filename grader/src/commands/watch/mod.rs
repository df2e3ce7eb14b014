//! `raybook watch`: checks again what a saved file changed; keys ask for more.

mod page;

use super::check::Check;
use super::explain::Explain;
use super::hint::Hint;
use super::{Done, Target, map};
use clap::{Parser, Subcommand};
use page::Page;
use raybook_chapters::kit::say::say;
use raybook_chapters::kit::say::{error_text, report};
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_grader::contain;
use raybook_grader::keys::{self, Pressed};
use raybook_grader::progress::Progress;
use raybook_grader::student;
use raybook_grader::watched::{Snapshot, changed};
use raybook_workbook::curriculum::{CHAPTERS, Chapter};
use std::error::Error;
use std::panic::resume_unwind;
use std::path::{Path, PathBuf};
use std::thread::{self, sleep};
use std::time::Duration;

/// How often the files are looked at, and how long they must stay the same after a save.
const PAUSE: Duration = Duration::from_millis(250);

/// How long a key is waited for, and then whether a check has ended.
const GLANCE: Duration = Duration::from_millis(30);

/// How deep hints go.
const LEVELS: u8 = 3;

/// Watches the workbook: whenever you save a file, checks what it changed, until you press Ctrl-C. In a terminal, keys hint, explain, go
/// on to the next chapter, list the course, and quit.
#[derive(clap::Args)]
pub struct Watch {
    #[command(flatten)]
    target: Target,
    /// No colours and no symbols in front of words
    #[arg(long)]
    plain: bool,
    /// Show the same as a page too, which renews itself: on this machine only, at an address that is told
    #[arg(long)]
    page: bool,
}

/// The words of another command, as they are typed.
#[derive(Parser)]
struct Line {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    Check(Check),
    Hint(Hint),
    Explain(Explain),
}

impl Watch {
    /// Checks, and checks again, until the command is interrupted or told to quit.
    pub fn run(&self) -> Done {
        let (from, _) = self.target.resolve()?;
        let folder = student::workbook(&from)?;
        let mut page = None;
        if self.page {
            let (served, address) = Page::serve(&folder)?;
            say(format!("The page: {address}"));
            page = Some(served);
        }
        let mut seen = Snapshot::of(&folder);
        let mut asked = self.asked();
        let mut names = Self::names(&asked, &folder, &[]);
        let mut hints = 0;
        let mut waiting = self.check(&folder, &names, page.as_mut())?;
        loop {
            match waiting
                .take()
                .map_or_else(|| keys::wait(PAUSE), Pressed::Key)
            {
                Pressed::Key('q') | Pressed::Closed => return Ok(true),
                Pressed::Key('n') => {
                    asked.clear(); // who goes on leaves what was asked for
                    names = next(&folder, &names);
                    hints = 0;
                    waiting = self.check(&folder, &names, page.as_mut())?;
                }
                Pressed::Key('h') => {
                    hints = LEVELS.min(hints + 1);
                    let level = ["--level".to_owned(), hints.to_string()];
                    waiting = self.command(&folder, "hint", &[&names[..], &level].concat())?;
                }
                Pressed::Key('e') => {
                    let open = open(&folder, &names);
                    waiting = self.command(&folder, "explain", &[open])?;
                }
                Pressed::Key('l') => list(&folder),
                Pressed::Key(_) | Pressed::Nothing => {}
            }
            let now = Snapshot::of(&folder);
            let files = changed(&seen, &now);
            if files.is_empty() {
                continue;
            }
            // Editors write a file in several steps, and people save several files: all of it is one change.
            sleep(PAUSE);
            let later = Snapshot::of(&folder);
            if !changed(&now, &later).is_empty() {
                continue;
            }
            seen = later;
            say(format!("\n── {} changed ──", told(&files)));
            hints = 0;
            names = Self::names(&asked, &folder, &files);
            waiting = self.check(&folder, &names, page.as_mut())?;
        }
    }

    /// Checks exercises or chapters by name, and shows on the page what became of them. Returns the key that waits for that.
    fn check(
        &self,
        folder: &Path,
        names: &[String],
        page: Option<&mut Page>,
    ) -> Result<Option<char>, clap::Error> {
        let Task::Check(check) = self.task("check", names)? else {
            return Ok(None);
        };
        let alone = page.as_ref().map(|page| page.alone());
        let drawn = page.is_some(); // it shows them, and they answer to clicks
        let (checked, waiting) = meanwhile(folder, || told_if_wrong(check.reports(drawn)));
        drop(alone);
        if let Some(page) = page {
            page.show(checked);
        }
        prompt();
        Ok(waiting)
    }

    /// Runs another command. What is wrong with the program is told, and does not end the watch. Returns the key that waits for its end.
    fn command(
        &self,
        folder: &Path,
        command: &str,
        words: &[String],
    ) -> Result<Option<char>, clap::Error> {
        let task = self.task(command, words)?;
        let run = || match &task {
            Task::Check(task) => task.run(),
            Task::Hint(task) => task.run(),
            Task::Explain(task) => task.run(),
        };
        let (_, waiting) = meanwhile(folder, || told_if_wrong(run()));
        prompt();
        Ok(waiting)
    }

    /// Another command, as if it were typed, with the folder as it was typed.
    fn task(&self, command: &str, names: &[String]) -> Result<Task, clap::Error> {
        let mut words = vec!["watch".to_owned(), command.to_owned()];
        words.extend_from_slice(names);
        words.extend((self.plain && command != "hint").then(|| "--plain".to_owned()));
        words.extend(self.target.folder().map(str::to_owned));
        Ok(Line::try_parse_from(words)?.task)
    }

    /// The exercises and chapters that were named when the watch began.
    fn asked(&self) -> Vec<String> {
        let asked = self.target.what.iter().map(String::as_str);
        let asked = asked.filter(|word| Some(*word) != self.target.folder());
        asked.map(str::to_owned).collect()
    }

    /// What to check: what was asked for; else the chapters of the files; else the first chapter that is not right yet.
    fn names(asked: &[String], folder: &Path, files: &[PathBuf]) -> Vec<String> {
        if !asked.is_empty() {
            return asked.to_vec();
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

/// Does some work, and obeys the keys that are pressed meanwhile: quits and lists at once; returns the last of the others, which has to wait.
fn meanwhile<T: Send>(folder: &Path, work: impl FnOnce() -> T + Send) -> (T, Option<char>) {
    thread::scope(|scope| {
        let work = scope.spawn(work);
        let mut waiting = None;
        while !work.is_finished() {
            match keys::wait(GLANCE) {
                Pressed::Key('q') | Pressed::Closed => contain::end_all(0),
                Pressed::Key('l') => list(folder),
                Pressed::Key(key @ ('h' | 'e' | 'n')) => {
                    say(format!("\n{key} comes next: a check is going on."));
                    waiting = Some(key);
                }
                Pressed::Key(_) | Pressed::Nothing => {}
            }
        }
        match work.join() {
            Ok(done) => (done, waiting),
            Err(panic) => resume_unwind(panic),
        }
    })
}

/// The same, once it is told; an error as its text, which other threads can read.
fn told_if_wrong<T>(done: Result<T, Box<dyn Error>>) -> Result<T, String> {
    done.map_err(|error| {
        report(&*error);
        error_text(&*error)
    })
}

/// Lists the course.
fn list(folder: &Path) {
    if let Err(error) = map::print(folder) {
        report(&*error);
    }
    prompt();
}

/// Says what can be done.
fn prompt() {
    let keys = if keys::are_there() {
        ", or press h hint (again: deeper), e explain, n next, l list, q quit"
    } else {
        ""
    };
    say(format!("\nSave a file to check again{keys}; Ctrl-C ends."));
}

/// The first of the named exercises that was not right when it was last checked; else the first.
fn open(folder: &Path, names: &[String]) -> String {
    let progress = Progress::load(folder).unwrap_or_default();
    let exercises = super::exercises(names).unwrap_or_default();
    let open = exercises.iter().find(|name| !progress.is_right(name));
    let open = open.or(exercises.first()).copied();
    open.unwrap_or(CHAPTERS[0].exercises()[0].name).to_owned()
}

/// The next chapter behind the named ones that is not right yet, and after the last the first again.
fn next(folder: &Path, names: &[String]) -> Vec<String> {
    let progress = Progress::load(folder).unwrap_or_default();
    let named = super::exercises(names).unwrap_or_default();
    let of_named = |chapter: &Chapter| {
        let mut exercises = chapter.exercises().iter();
        exercises.any(|exercise| named.contains(&exercise.name))
    };
    let is_open = |chapter: &&Chapter| {
        let mut exercises = chapter.exercises().iter();
        exercises.any(|exercise| !progress.is_right(exercise.name))
    };
    let behind = CHAPTERS.iter().rposition(of_named).map_or(0, |i| i + 1);
    let (before, behind) = CHAPTERS.split_at(behind);
    let next = behind.iter().chain(before).find(is_open);
    next.map_or_else(|| names.to_vec(), |chapter| vec![chapter.name.to_owned()])
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
