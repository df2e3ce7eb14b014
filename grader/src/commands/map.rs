//! `raybook` alone: the map of the course, in a workbook with the states of all exercises, and the next step.

use super::{Done, by_cargo, next};
use raybook_chapters::kit::say::say;
use raybook_chapters::lesson::{self, Lesson};
use raybook_grader::progress::Progress;
use raybook_grader::{json, student};
use raybook_workbook::curriculum::{CHAPTERS, Chapter};
use std::path::Path;

/// Prints the map; with progress, if there is a workbook in this folder or above.
pub fn print(from: &Path) -> Done {
    let workbook = student::workbook(from).ok();
    let (progress, unknown) = match workbook.as_deref().map(Progress::load) {
        Some(Err(error)) => (Some(Progress::default()), Some(error)),
        Some(Ok(progress)) => (Some(progress), None),
        None => (None, None),
    };
    say("raybook: a ray-tracing course that you can run\n");
    for chapter in CHAPTERS {
        let told = match &progress {
            Some(progress) => standing(chapter, progress) + &states(chapter, progress),
            None => lesson::find(chapter.name).map_or_else(String::new, Lesson::teaches),
        };
        say(format!(
            "  {:2}  {:<25} {told}",
            chapter.number(),
            chapter.title,
        ));
    }
    if let Some((folder, progress)) = workbook.zip(progress) {
        say(format!("\n{}", next::in_course(&folder, &progress)));
    } else {
        let run = by_cargo().unwrap_or("raybook");
        say(format!("\nNext: see every chapter's pictures   {run} tour"));
        say(format!(
            "      draw one chapter's pictures    {run} tour --only {}",
            CHAPTERS[0].name
        ));
        say(format!(
            "      write your own ray tracer      {run} new ../my-rays"
        ));
    }
    unknown.map_or(Ok(true), |error| Err(error.into()))
}

/// The exercises of a chapter by their states: "right: ray_at; not checked: camera_ray".
fn states(chapter: &Chapter, progress: &Progress) -> String {
    let state = |name| {
        let state = progress.state(name);
        state.map_or("not checked", |state| json::state_name(&state).0)
    };
    let mut groups: Vec<(&str, Vec<&str>)> = Vec::new();
    for exercise in chapter.exercises() {
        let state = state(exercise.name);
        match groups.iter_mut().find(|group| group.0 == state) {
            Some((_, names)) => names.push(exercise.name),
            None => groups.push((state, vec![exercise.name])),
        }
    }
    let groups = groups.iter();
    let groups = groups.map(|(state, names)| format!("{state}: {}", names.join(", ")));
    groups.collect::<Vec<_>>().join("; ")
}

/// How many of a chapter's exercises are right: "[2 of 3] ".
fn standing(chapter: &Chapter, progress: &Progress) -> String {
    let right = chapter
        .exercises()
        .iter()
        .filter(|exercise| progress.is_right(exercise.name))
        .count();
    format!("[{right} of {}] ", chapter.exercises().len())
}
