//! The course file: what is graded, what it counts, until when, and what hand-ins may use.

mod read;

use super::when::Timestamp;
use crate::budget::Total;
use crate::converse::Limits;
use crate::examine::Examiner;
use crate::language::Language;
use crate::{cases, library};
use raybook_workbook::curriculum::{CHAPTERS, Chapter};
use std::fmt::Write;
use std::path::PathBuf;
use std::time::Duration;

/// What a course file says.
#[derive(Clone, Debug)]
pub struct Course {
    /// Its title.
    pub title: String,
    /// The term: another one, other hidden cases.
    pub term: String,
    /// The languages that hand-ins may be written in.
    pub languages: Vec<Language>,
    /// The share of an exercise's points for right cases of an exercise that is not right as a whole.
    pub partial: f64,
    /// What handing in late costs.
    pub late: Late,
    /// Whether references may be taken.
    pub solve: Solve,
    /// What a hand-in may use.
    pub limits: Allowed,
    /// What is graded, chapter by chapter, and after them the exercises of the instructor's own.
    pub chapters: Vec<Plan>,
    /// The exercises of the instructor's own.
    pub own: Own,
}

/// Exercises of the instructor's own.
#[derive(Clone, Default)]
pub struct Own {
    /// Their folders, which no hand-in may read.
    pub folders: Vec<PathBuf>,
    /// All of them, in the order of the folders.
    pub exercises: Vec<&'static dyn Examiner>,
}

impl std::fmt::Debug for Own {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let names = self.exercises.iter().map(|examiner| examiner.name());
        f.debug_list().entries(names).finish()
    }
}

/// What handing in late costs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Late {
    /// Seconds after the due time that cost nothing.
    pub grace: i64,
    /// The share of a chapter's points that each day begun costs.
    pub per_day: f64,
    /// The largest share that is lost.
    pub at_most: f64,
}

/// What taking a reference means.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solve {
    /// Whether `raybook solve` gives references out in workbooks of this course.
    pub allowed: bool,
    /// The share of an exercise's points that its reference costs.
    pub costs: f64,
}

/// What a hand-in may use.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Allowed {
    /// Time for one answer.
    pub answer: Duration,
    /// Time for all answers of an exercise.
    pub exercise: Duration,
    /// Memory, in bytes.
    pub memory: u64,
    /// Files of a hand-in.
    pub files: usize,
    /// Bytes of a hand-in.
    pub bytes: u64,
}

/// A chapter of the course.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The chapter.
    pub chapter: &'static Chapter,
    /// What its points are multiplied by.
    pub weight: f64,
    /// When it is due; never if `None`.
    pub due: Option<Timestamp>,
    /// Its exercises that count.
    pub exercises: Vec<Counted>,
}

/// An exercise that counts.
#[derive(Clone, Debug, PartialEq)]
pub struct Counted {
    /// Its name.
    pub name: &'static str,
    /// Its points, before the chapter's weight.
    pub points: f64,
    /// Whether its points come on top of those that can be reached.
    pub bonus: bool,
}

impl Course {
    /// The points that can be reached without a bonus.
    pub fn reachable(&self) -> f64 {
        let ordinary = |plan: &Plan| {
            let points = plan.exercises.iter().filter(|counted| !counted.bonus);
            plan.weight * points.map(|counted| counted.points).sum::<f64>()
        };
        self.chapters.iter().map(ordinary).sum()
    }

    /// The exercises, in the order of the course.
    pub fn examiners(&self) -> Vec<&'static dyn Examiner> {
        let exercises = self.chapters.iter().flat_map(|plan| &plan.exercises);
        let own = |name| {
            self.own
                .exercises
                .iter()
                .copied()
                .find(|own| own.name() == name)
        };
        exercises
            .filter_map(|counted| cases::find(counted.name).or_else(|| own(counted.name)))
            .collect()
    }
}

impl Allowed {
    /// The limits of asking. Nothing but its own exercise counts against an exercise, so that it is the same whether a
    /// grader asked others before it or was interrupted.
    pub fn asking(&self) -> Limits {
        let mut limits = Limits::of(self.answer);
        limits.exercise.time = self.exercise;
        limits.check = Total {
            time: Duration::from_secs(u64::from(u32::MAX)),
            bytes: usize::MAX,
        };
        limits
    }
}

/// The text of a new course file: everything that can be set, with what holds where it is not, and all chapters.
pub fn template() -> String {
    let mut text = include_str!("../course.toml.txt").to_owned();
    for chapter in CHAPTERS {
        let names = chapter.exercises().iter().map(|exercise| exercise.name);
        let names: Vec<_> = names
            .filter(|name| library::place(name).is_some())
            .map(|name| format!("\"{name}\""))
            .collect();
        let _ = write!(
            text,
            "\n[[chapter]] # {}\nchapter = \"{}\"\nexercises = [{}]\n",
            chapter.title,
            chapter.name,
            names.join(", ")
        );
    }
    text
}
