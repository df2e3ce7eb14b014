//! Annotations for GitHub: commands that a workflow prints
//! (<https://docs.github.com/en/actions/reference/workflows-and-actions/workflow-commands>), a line for each exercise that is not right.

use super::outcome::{Status, outcome, visible, why};
use crate::class::grades::{ExerciseGrade, Grade};
use crate::class::stage::PLACE;
use raybook_chapters::kit::untrusted::Untrusted;
use std::path::{Component, Path};

/// The annotations of a hand-in. Files are those of the hand-in, by their paths in it.
pub fn annotations(grade: &Grade) -> String {
    if let Err(why) = &grade.sheet.print {
        let message = format!("The hand-in cannot be graded: {why}");
        return command("error", &[("title", &grade.sheet.student)], &message);
    }
    grade
        .exercises()
        .map(|exercise| annotation(grade, exercise))
        .collect()
}

fn annotation(grade: &Grade, exercise: &ExerciseGrade) -> String {
    let level = match outcome(grade, exercise) {
        Status::Passed => return String::new(),
        Status::Skipped => "notice",
        Status::Failed => "error",
        Status::Error => "warning",
    };
    let title = format!("{}: {}", grade.sheet.student, exercise.counted.name);
    let message = why(grade, exercise);
    match place(&message) {
        Some((file, line)) => command(
            level,
            &[
                ("file", &file),
                ("line", &line.to_string()),
                ("title", &title),
            ],
            &message,
        ),
        None => command(level, &[("title", &title)], &message),
    }
}

/// A line that the runner takes as one command, whatever the words in it are.
fn command(level: &str, properties: &[(&str, &str)], message: &str) -> String {
    let properties: Vec<_> = properties
        .iter()
        .map(|(name, value)| {
            let value = Untrusted::from(*value).to_string();
            let value = escaped(&value).replace(':', "%3A").replace(',', "%2C");
            format!("{name}={value}")
        })
        .collect();
    let message = escaped(&visible(message));
    format!("::{level} {}::{message}\n", properties.join(","))
}

/// What ends a command or begins an escape, by its number; the percent sign first, which the others bring with them.
fn escaped(text: &str) -> String {
    text.replace('%', "%25")
        .replace('\r', "%0D")
        .replace('\n', "%0A")
}

/// The file and the line that a compiler or Python names, if the file is one of the hand-in's folder.
fn place(words: &str) -> Option<(String, u32)> {
    let compiled = words
        .lines()
        .skip_while(|line| !line.contains("error"))
        .find_map(of_compiler);
    // The last call of a traceback in the hand-in is where it broke.
    let (file, line) = compiled.or_else(|| words.lines().rev().find_map(of_python))?;
    let is_inside = Path::new(file)
        .components()
        .all(|part| matches!(part, Component::Normal(_) | Component::CurDir));
    let file = file.strip_prefix("./").unwrap_or(file);
    is_inside.then(|| (file.to_owned(), line))
}

/// `./answer.cpp:3:5: error: …` or `  --> src/lib.rs:3:5`.
fn of_compiler(line: &str) -> Option<(&str, u32)> {
    let line = line.trim_start();
    let line = line.strip_prefix("--> ").unwrap_or(line);
    let (place, _) = line.split_once(": ").unwrap_or((line, ""));
    let (place, column) = place.rsplit_once(':')?;
    let (file, line) = place.rsplit_once(':')?;
    column.parse::<u32>().ok()?;
    Some((file, line.parse().ok()?))
}

/// `  File "hand-in/answer.py", line 3, in …`.
fn of_python(line: &str) -> Option<(&str, u32)> {
    let (_, rest) = line.split_once("File \"")?;
    let (file, rest) = rest.split_once("\", line ")?;
    let file = file.strip_prefix(PLACE)?.strip_prefix('/')?;
    let (number, _) = rest.split_once(',').unwrap_or((rest, ""));
    Some((file, number.trim().parse().ok()?))
}
