//! `raybook` alone: the map of the course, in a workbook with the student's progress, and the next step.

use super::Done;
use raybook_chapters::kit::say::say;
use raybook_chapters::lesson::{self, Lesson};
use raybook_grader::progress::Progress;
use raybook_grader::student;
use raybook_workbook::curriculum::{CHAPTERS, Chapter};
use std::path::Path;

/// Prints the map; with progress, if there is a workbook in this folder or above.
pub fn print(from: &Path) -> Done {
    let kept = student::workbook(from)
        .ok()
        .map(|folder| Progress::load(&folder));
    let (progress, unknown) = match kept {
        Some(Err(error)) => (Some(Progress::default()), Some(error)),
        Some(Ok(progress)) => (Some(progress), None),
        None => (None, None),
    };
    say("raybook: a ray-tracing course that you can run\n");
    for chapter in CHAPTERS {
        let done = progress
            .as_ref()
            .map_or_else(String::new, |progress| standing(chapter, progress));
        say(format!(
            "  {:2}  {:<25} {done}{}",
            chapter.number(),
            chapter.title,
            lesson::find(chapter.name).map_or_else(String::new, Lesson::teaches)
        ));
    }
    if let Some(progress) = progress {
        let all = CHAPTERS.iter().flat_map(Chapter::exercises);
        match all
            .into_iter()
            .find(|exercise| !progress.is_right(exercise.name))
        {
            Some(exercise) => say(format!("\nNext: raybook check {}", exercise.name)),
            None => say("\nEvery exercise is right."),
        }
    } else {
        // Cargo tells what it runs where it is: who has only the command types its name.
        let run = match std::env::var_os("CARGO") {
            Some(_) => "cargo run --release --",
            None => "raybook",
        };
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

/// How many of a chapter's exercises are right: "[2 of 3] ".
fn standing(chapter: &Chapter, progress: &Progress) -> String {
    let right = chapter
        .exercises()
        .iter()
        .filter(|exercise| progress.is_right(exercise.name))
        .count();
    format!("[{right} of {}] ", chapter.exercises().len())
}
