//! A student's page: points, and what is wrong, without a word about hidden cases. It needs no other file.

use super::words;
use crate::class::grades::{ChapterGrade, Grade, points};
use crate::class::record::Standing;
use crate::class::roll::Class;
use maud::{Markup, html};
use raybook_chapters::kit::html;
use raybook_chapters::kit::untrusted::Untrusted;

/// The page.
pub fn page(class: &Class<'_>, grade: &Grade) -> String {
    let student = Untrusted::from(grade.sheet.student.as_str());
    let body = html! {
        h1 { (student) ": " (points(grade.points())) " of " (points(grade.of_points())) " points" }
        p { (Untrusted::from(class.course.title.as_str())) @if !class.course.term.is_empty() { ", " (Untrusted::from(class.course.term.as_str())) }
            ". Graded " (class.when) " by raybook " (env!("CARGO_PKG_VERSION")) "."
            @if let Some(when) = grade.sheet.handed_in { " Handed in " (when) "." } }
        @if let Err(why) = &grade.sheet.print { p { strong { "The hand-in cannot be graded: " (Untrusted::from(why.as_str())) "." } } }
        @else if !grade.is_complete() { p { strong { "Something could not be graded yet; it is no zero, and is tried again." } } }
        @for note in &grade.sheet.notes { p { (Untrusted::from(note.as_str())) "." } }
        @for chapter in &grade.chapters { (chapter_section(chapter)) }
    };
    html::page(
        &format!("{student}: {} points", points(grade.points())),
        &body,
    )
}

fn chapter_section(chapter: &ChapterGrade) -> Markup {
    html! { section {
        h2 { (chapter.title) ": " (points(chapter.points())) " of " (points(chapter.of_points())) }
        @if chapter.weight != 1.0 { p { "Its points count " (points(chapter.weight)) " times." } }
        @if chapter.lost > 0.0 { p { "Handed in " (chapter.days_late) @if chapter.days_late == 1 { " day" } @else { " days" } " late: "
            (points(100.0 * chapter.lost)) " % of the points are lost." } }
        (html::table(&format!("The exercises of {}", chapter.title), &html! {
            tr { th { "exercise" } th { "points" } th { "of" } th { "cases right" } th style="text-align:left" { "" } }
            @for exercise in &chapter.exercises { tr {
                td { code { (exercise.counted.name) } @if exercise.counted.bonus { " (bonus)" } }
                td { (exercise.points.map_or_else(|| "–".to_owned(), points)) }
                td { (points(exercise.counted.points)) }
                td { @if let Some(result) = exercise.result.as_ref().filter(|result| result.right[1] > 0 && result.standing != Standing::NotStarted) {
                    (result.right[0]) " of " (result.right[1]) } }
                td style="text-align:left" { @for line in words(exercise).lines() { (Untrusted::from(line)) br; } }
            } }
        }))
    } }
}
