//! The map of the course: every chapter with its state, and the way to what was checked of it.

use super::{Page, is_right};
use maud::{Markup, html};
use raybook_workbook::curriculum::{CHAPTERS, Chapter};

/// The map of a page. Without kept progress it shows the chapters of which something was checked.
pub fn of(page: &Page<'_>) -> Markup {
    let chapters = CHAPTERS
        .iter()
        .map(|chapter| (chapter, states(page, chapter)));
    html! { nav aria-label="Map of the course" { ol {
        @for (chapter, states) in chapters.filter(|(_, states)| !states.is_empty()) { li { (entry(page, chapter, &states)) } }
    } } }
}

/// A chapter; with a link, if something was checked of it.
fn entry(page: &Page<'_>, chapter: &Chapter, states: &[bool]) -> Markup {
    let right = states.iter().filter(|right| **right).count();
    let sign = match right {
        0 => "○",
        right if right < states.len() => "◐",
        _ => "●",
    };
    let text = html! {
        span aria-hidden="true" { (sign) } " " (chapter.number()) " " (chapter.title) ": " (right) " of " (states.len()) " right"
    };
    html! {
        @if page.of(chapter).next().is_some() { a href={ "#" (chapter.name) } { (text) } }
        @else { (text) }
    }
}

/// Whether each exercise of a chapter is right: now, if it was checked, or else when it was last checked, if that is kept.
fn states(page: &Page<'_>, chapter: &Chapter) -> Vec<bool> {
    let state = |exercise: &str| {
        let now = page
            .reports
            .iter()
            .find(|report| report.exercise == exercise);
        let before = || Some(page.progress?.is_right(exercise));
        now.map(is_right).or_else(before)
    };
    let exercises = chapter.exercises().iter();
    exercises
        .filter_map(|exercise| state(exercise.name))
        .collect()
}
