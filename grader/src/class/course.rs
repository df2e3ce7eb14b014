//! The course file: what is graded, what it counts, until when, and what hand-ins may use.

use super::settings::{Placed, SettingsError, Source, Table, unknown_name};
use super::when::Instant;
use crate::budget::Total;
use crate::converse::Limits;
use crate::examine::Examiner;
use crate::language::Language;
use crate::{cases, library, own};
use raybook_workbook::curriculum::{CHAPTERS, Chapter};
use std::collections::BTreeSet;
use std::fmt::Write;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
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
    pub due: Option<Instant>,
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

const POINTS: RangeInclusive<f64> = 0.0..=1e6;
const SHARE: RangeInclusive<f64> = 0.0..=1.0;
const MEBIBYTE: f64 = 1_048_576.0;

impl Course {
    /// The course of a course file.
    ///
    /// # Errors
    /// What is wrong in the file, with its line and column.
    pub fn read(file: &Path, text: &str) -> Result<Self, SettingsError> {
        let source = Source { file, text };
        let parsed = source.parse()?;
        let top = Table::new(source, parsed.get_ref());
        let points = top.number("points", POINTS)?.unwrap_or(1.0);
        let mut chapters = chapters(source, &top, points)?;
        let own = own(source, &top, points, &mut chapters)?;
        let course = Self {
            title: text_of(&top, "title", "Ray tracing")?,
            term: text_of(&top, "term", "")?,
            languages: languages(source, &top)?,
            partial: top.number("partial", SHARE)?.unwrap_or(0.5),
            late: late(top.table("late")?.as_ref())?,
            solve: solve(top.table("solve")?.as_ref())?,
            limits: limits(top.table("limits")?.as_ref())?,
            chapters,
            own,
        };
        top.finish()?;
        if course.chapters.is_empty() {
            let what = "nothing is graded: a [[chapter]] with `chapter = \"ch01\"` grades the exercises of the first";
            return Err(source.error(&(0..0), what));
        }
        Ok(course)
    }

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

impl Solve {
    /// What a course file says of references, and nothing else: the copy in a workbook has no folders beside it.
    ///
    /// # Errors
    /// What is wrong in the file, with its line and column.
    pub fn read(file: &Path, text: &str) -> Result<Self, SettingsError> {
        let source = Source { file, text };
        let parsed = source.parse()?;
        let top = Table::new(source, parsed.get_ref());
        solve(top.table("solve")?.as_ref())
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

fn text_of(
    table: &Table<'_>,
    name: &'static str,
    otherwise: &str,
) -> Result<String, SettingsError> {
    let text = table.text(name)?;
    Ok(text.map_or(otherwise, |text| text.value).to_owned())
}

fn languages(source: Source<'_>, top: &Table<'_>) -> Result<Vec<Language>, SettingsError> {
    let Some(words) = top.words("languages")? else {
        return Ok(Language::ALL.to_vec());
    };
    let of = |word: Placed<&str>| {
        let names = Language::ALL.into_iter().map(Language::name);
        Language::find(word.value).ok_or_else(|| {
            let what = unknown_name("language", word.value, names);
            source.error(&word.at, what)
        })
    };
    words.into_iter().map(of).collect()
}

fn late(table: Option<&Table<'_>>) -> Result<Late, SettingsError> {
    let mut late = Late {
        grace: 0,
        per_day: 0.0,
        at_most: 1.0,
    };
    if let Some(table) = table {
        let minutes = table.number("grace_minutes", 0.0..=1e6)?;
        late.grace = (minutes.unwrap_or(0.0) * 60.0) as i64;
        late.per_day = table.number("per_day", SHARE)?.unwrap_or(late.per_day);
        late.at_most = table.number("at_most", SHARE)?.unwrap_or(late.at_most);
        table.finish()?;
    }
    Ok(late)
}

fn solve(table: Option<&Table<'_>>) -> Result<Solve, SettingsError> {
    let mut solve = Solve {
        allowed: true,
        costs: 1.0,
    };
    if let Some(table) = table {
        solve.allowed = table.yes("allowed")?.unwrap_or(solve.allowed);
        solve.costs = table.number("costs", SHARE)?.unwrap_or(solve.costs);
        table.finish()?;
    }
    Ok(solve)
}

fn limits(table: Option<&Table<'_>>) -> Result<Allowed, SettingsError> {
    let or = |name, range, otherwise| -> Result<f64, SettingsError> {
        let read = table.map_or(Ok(None), |table| table.number(name, range))?;
        Ok(read.unwrap_or(otherwise))
    };
    let limits = Allowed {
        answer: Duration::from_secs_f64(or("answer_seconds", 0.1..=3600.0, 2.0)?),
        exercise: Duration::from_secs_f64(or("exercise_seconds", 1.0..=36000.0, 60.0)?),
        memory: (or("memory_megabytes", 64.0..=1e6, 1024.0)? * MEBIBYTE) as u64,
        files: or("files", 1.0..=1e5, 1000.0)? as usize,
        bytes: (or("megabytes", 0.1..=1000.0, 20.0)? * MEBIBYTE) as u64,
    };
    table.map_or(Ok(()), Table::finish)?;
    Ok(limits)
}

fn chapters(source: Source<'_>, top: &Table<'_>, points: f64) -> Result<Vec<Plan>, SettingsError> {
    let mut plans: Vec<Plan> = Vec::new();
    for Placed { value: table, at } in top.tables("chapter")? {
        let plan = plan(source, &table, &at, points)?;
        if plans
            .iter()
            .any(|other| other.chapter.name == plan.chapter.name)
        {
            let what = format!(
                "{} is graded twice; one [[chapter]] is enough",
                plan.chapter.name
            );
            return Err(source.error(&at, what));
        }
        plans.push(plan);
    }
    Ok(plans)
}

fn plan(
    source: Source<'_>,
    table: &Table<'_>,
    at: &std::ops::Range<usize>,
    points: f64,
) -> Result<Plan, SettingsError> {
    let Some(word) = table.text("chapter")? else {
        let what = "which chapter? `chapter = \"ch01\"`, or its whole name, must stand here";
        return Err(source.error(at, what));
    };
    let chapter = CHAPTERS
        .iter()
        .find(|chapter| chapter.answers_to(word.value))
        .ok_or_else(|| {
            let names = CHAPTERS.iter().map(|chapter| chapter.name);
            source.error(&word.at, unknown_name("chapter", word.value, names))
        })?;
    let names = chapter.exercises().iter();
    let names: Vec<_> = names.map(|exercise| exercise.name).collect();
    planned(source, table, chapter, &names, points)
}

/// The tables of the exercises of the instructor's own: a plan for each folder, after those of the chapters.
fn own(
    source: Source<'_>,
    top: &Table<'_>,
    points: f64,
    plans: &mut Vec<Plan>,
) -> Result<Own, SettingsError> {
    let mut all = Own::default();
    for Placed { value: table, at } in top.tables("own")? {
        let Some(word) = table.text("folder")? else {
            let what = "in which folder? `folder = \"own\"`, beside this file, must stand here";
            return Err(source.error(&at, what));
        };
        let program = table.words("program")?.unwrap_or_default();
        let program: Vec<_> = program.iter().map(|word| word.value).collect();
        let beside = source.file.parent().unwrap_or(Path::new(""));
        let folder = beside.join(word.value);
        let wrong = |what: String| source.error(&word.at, what);
        let exercises = own::read(&folder, &program).map_err(wrong)?;
        let names: Vec<_> = exercises.iter().map(|examiner| examiner.name()).collect();
        let is_there = |name: &&str| all.exercises.iter().any(|other| other.name() == *name);
        if let Some(name) = names.iter().copied().find(|name| is_there(name)) {
            return Err(wrong(format!(
                "two of your own exercises are called {name}"
            )));
        }
        let file_name = folder.file_name().unwrap_or(folder.as_os_str());
        let name = file_name.to_string_lossy().into_owned();
        let title = text_of(&table, "title", "Own exercises")?;
        let is_taken = |plan: &Plan| plan.chapter.name == name || plan.chapter.title == title;
        if plans.iter().any(is_taken) {
            return Err(wrong(format!(
                "{name}, {title}: another part of the course has this name or this title"
            )));
        }
        // Once for each folder: the command ends soon.
        let chapter = Box::leak(Box::new(Chapter {
            name: name.leak(),
            title: title.leak(),
            needs: &[],
        }));
        plans.push(planned(source, &table, chapter, &names, points)?);
        all.exercises.extend(exercises);
        all.folders.push(folder);
    }
    Ok(all)
}

/// What a table says of exercises of these names: which count, and how much.
fn planned(
    source: Source<'_>,
    table: &Table<'_>,
    chapter: &'static Chapter,
    names: &[&'static str],
    points: f64,
) -> Result<Plan, SettingsError> {
    let points = table.number("points", POINTS)?.unwrap_or(points);
    let mut exercises = Vec::new();
    let mut seen = BTreeSet::new();
    let all = || names.iter().copied();
    let ordinary = table.numbered("exercises", points, &POINTS)?;
    let bonus = table.numbered("bonus", points, &POINTS)?;
    let counted = [(ordinary.clone(), false), (bonus, true)];
    for (names, bonus) in counted {
        for (name, points) in names.into_iter().flatten() {
            let Some(known) = all().find(|known| *known == name.value) else {
                let what =
                    unknown_name(&format!("exercise in {}", chapter.name), name.value, all());
                return Err(source.error(&name.at, what));
            };
            if !seen.insert(known) {
                let what = format!("{known} counts already");
                return Err(source.error(&name.at, what));
            }
            exercises.push(Counted {
                name: known,
                points,
                bonus,
            });
        }
    }
    if ordinary.is_none() {
        let rest = all().filter(|name| !seen.contains(name));
        exercises.extend(rest.map(|name| Counted {
            name,
            points,
            bonus: false,
        }));
    }
    let plan = Plan {
        chapter,
        weight: table.number("weight", POINTS)?.unwrap_or(1.0),
        due: table.instant("due")?,
        exercises,
    };
    table.finish()?;
    Ok(plan)
}

/// The text of a new course file: everything that can be set, with what holds where it is not, and all chapters.
pub fn template() -> String {
    let mut text = include_str!("course.toml.txt").to_owned();
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
