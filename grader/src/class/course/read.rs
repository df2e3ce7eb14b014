//! How a course file is read.

use super::{Allowed, Counted, Course, Late, Own, Plan, Solve};
use crate::class::settings::{Word, instant, numbered, words};
use crate::language::Language;
use crate::own;
use raybook_scenes::fields::Fields;
use raybook_scenes::wrong::{Source, TextError, no_such};
use raybook_workbook::curriculum::{self, CHAPTERS, Chapter};
use std::collections::BTreeSet;
use std::ops::RangeInclusive;
use std::path::Path;
use std::time::Duration;

const POINTS: RangeInclusive<f64> = 0.0..=1e6;
const SHARE: RangeInclusive<f64> = 0.0..=1.0;
const MEBIBYTE: f64 = 1_048_576.0;

impl Course {
    /// The course of a course file.
    ///
    /// # Errors
    /// What is wrong in the file, with its line and column.
    pub fn read(file: &Path, text: &str) -> Result<Self, TextError> {
        let source = Source { path: file, text };
        let parsed = source.parse()?;
        let top = Fields::new(source, "a course", 0, parsed.get_ref());
        let points = top.precise("points", &POINTS)?.unwrap_or(1.0);
        let mut chapters = chapters(&top, points)?;
        let own = own(&top, points, &mut chapters)?;
        let course = Self {
            title: text_of(&top, "title", "Ray tracing")?,
            term: text_of(&top, "term", "")?,
            languages: languages(&top)?,
            partial: top.precise("partial", &SHARE)?.unwrap_or(0.5),
            late: late(top.table("late", "[late]")?)?,
            solve: solve(top.table("solve", "[solve]")?)?,
            limits: limits(top.table("limits", "[limits]")?)?,
            chapters,
            own,
        };
        top.finish()?;
        if course.chapters.is_empty() {
            let what = "nothing is graded: a [[chapter]] with `chapter = \"ch01\"` grades the exercises of the first";
            return Err(source.wrong(0, what));
        }
        Ok(course)
    }
}

impl Solve {
    /// What a course file says of references, and nothing else: the copy in a workbook has no folders beside it.
    ///
    /// # Errors
    /// What is wrong in the file, with its line and column.
    pub fn read(file: &Path, text: &str) -> Result<Self, TextError> {
        let source = Source { path: file, text };
        let parsed = source.parse()?;
        let top = Fields::new(source, "a course", 0, parsed.get_ref());
        solve(top.table("solve", "[solve]")?)
    }
}

fn text_of(table: &Fields<'_>, name: &'static str, otherwise: &str) -> Result<String, TextError> {
    Ok(table.text(name)?.unwrap_or(otherwise).to_owned())
}

fn languages(top: &Fields<'_>) -> Result<Vec<Language>, TextError> {
    let Some(words) = words(top, "languages")? else {
        return Ok(Language::ALL.to_vec());
    };
    let of = |word: Word<'_>| {
        let names = Language::ALL.into_iter().map(Language::name);
        Language::find(word.text).ok_or_else(|| {
            let what = no_such("language", word.text, names);
            top.source().wrong(word.at, what)
        })
    };
    words.into_iter().map(of).collect()
}

fn late(table: Option<Fields<'_>>) -> Result<Late, TextError> {
    let mut late = Late {
        grace: 0,
        per_day: 0.0,
        at_most: 1.0,
    };
    if let Some(table) = table {
        let minutes = table.precise("grace_minutes", &(0.0..=1e6))?;
        late.grace = (minutes.unwrap_or(0.0) * 60.0) as i64;
        late.per_day = table.precise("per_day", &SHARE)?.unwrap_or(late.per_day);
        late.at_most = table.precise("at_most", &SHARE)?.unwrap_or(late.at_most);
        table.finish()?;
    }
    Ok(late)
}

fn solve(table: Option<Fields<'_>>) -> Result<Solve, TextError> {
    let mut solve = Solve {
        allowed: true,
        costs: 1.0,
    };
    if let Some(table) = table {
        solve.allowed = table.yes("allowed")?.unwrap_or(solve.allowed);
        solve.costs = table.precise("costs", &SHARE)?.unwrap_or(solve.costs);
        table.finish()?;
    }
    Ok(solve)
}

fn limits(table: Option<Fields<'_>>) -> Result<Allowed, TextError> {
    let or = |name, range, otherwise| -> Result<f64, TextError> {
        let read = table.as_ref().map(|table| table.precise(name, &range));
        Ok(read.transpose()?.flatten().unwrap_or(otherwise))
    };
    let limits = Allowed {
        answer: Duration::from_secs_f64(or("answer_seconds", 0.1..=3600.0, 2.0)?),
        exercise: Duration::from_secs_f64(or("exercise_seconds", 1.0..=36000.0, 60.0)?),
        memory: (or("memory_megabytes", 64.0..=1e6, 1024.0)? * MEBIBYTE) as u64,
        files: or("files", 1.0..=1e5, 1000.0)? as usize,
        bytes: (or("megabytes", 0.1..=1000.0, 20.0)? * MEBIBYTE) as u64,
    };
    table.map_or(Ok(()), Fields::finish)?;
    Ok(limits)
}

fn chapters(top: &Fields<'_>, points: f64) -> Result<Vec<Plan>, TextError> {
    let mut plans: Vec<Plan> = Vec::new();
    for table in top.tables("chapter", "a chapter")? {
        let at = table.start();
        let plan = plan(table, points)?;
        if plans
            .iter()
            .any(|other| other.chapter.name == plan.chapter.name)
        {
            let what = format!(
                "{} is graded twice; one [[chapter]] is enough",
                plan.chapter.name
            );
            return Err(top.source().wrong(at, what));
        }
        plans.push(plan);
    }
    Ok(plans)
}

fn plan(table: Fields<'_>, points: f64) -> Result<Plan, TextError> {
    let value = table.value("chapter");
    let word = if value.is_some_and(|value| value.get_ref().is_integer()) {
        let chapters = 1..=CHAPTERS.len() as u64;
        let number = table.whole("chapter", chapters)?;
        number.map(|number| number.to_string())
    } else {
        table.text("chapter")?.map(str::to_owned)
    };
    let Some(word) = word else {
        let what =
            "which chapter? `chapter = \"ch01\"`, its number or its whole name must stand here";
        return Err(table.wrong("chapter", what));
    };
    let chapter = curriculum::called(&word).ok_or_else(|| {
        let names = CHAPTERS.iter().map(|chapter| chapter.name);
        table.wrong("chapter", no_such("chapter", &word, names))
    })?;
    let names = chapter.exercises().iter();
    let names: Vec<_> = names.map(|exercise| exercise.name).collect();
    planned(table, chapter, &names, points)
}

/// The tables of the exercises of the instructor's own: a plan for each folder, after those of the chapters.
fn own(top: &Fields<'_>, points: f64, plans: &mut Vec<Plan>) -> Result<Own, TextError> {
    let mut all = Own::default();
    for table in top.tables("own", "a folder of your own")? {
        let Some(word) = table.text("folder")? else {
            let what = "in which folder? `folder = \"own\"`, beside this file, must stand here";
            return Err(table.wrong("folder", what));
        };
        let program = words(&table, "program")?.unwrap_or_default();
        let program: Vec<_> = program.iter().map(|word| word.text).collect();
        let folder = top.source().beside(word);
        let wrong = |what: String| table.wrong("folder", what);
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
        plans.push(planned(table, chapter, &names, points)?);
        all.exercises.extend(exercises);
        all.folders.push(folder);
    }
    Ok(all)
}

/// What a table says of exercises of these names: which count, and how much.
fn planned(
    table: Fields<'_>,
    chapter: &'static Chapter,
    names: &[&'static str],
    points: f64,
) -> Result<Plan, TextError> {
    let points = table.precise("points", &POINTS)?.unwrap_or(points);
    let mut exercises = Vec::new();
    let mut seen = BTreeSet::new();
    let all = || names.iter().copied();
    let ordinary = numbered(&table, "exercises", points, &POINTS)?;
    let bonus = numbered(&table, "bonus", points, &POINTS)?;
    let counted = [(ordinary.clone(), false), (bonus, true)];
    for (names, bonus) in counted {
        for (name, points) in names.into_iter().flatten() {
            let Some(known) = all().find(|known| *known == name.text) else {
                let what = no_such(&format!("exercise in {}", chapter.name), name.text, all());
                return Err(table.source().wrong(name.at, what));
            };
            if !seen.insert(known) {
                let what = format!("{known} counts already");
                return Err(table.source().wrong(name.at, what));
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
        weight: table.precise("weight", &POINTS)?.unwrap_or(1.0),
        due: instant(&table, "due")?,
        exercises,
    };
    table.finish()?;
    Ok(plan)
}
