//! The page of a class, for its instructor: everybody's points, what the class gets wrong, and hand-ins that are nearly identical.

use super::STUDENTS;
use crate::class::grades::{Grade, points};
use crate::class::items::Item;
use crate::class::record::{Marked, Standing};
use crate::class::roll::Class;
use maud::{Markup, html};
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_chapters::kit::{address, html};

/// The page.
pub fn page(class: &Class<'_>) -> String {
    let title = Untrusted::from(class.course.title.as_str());
    let complete = class
        .grades
        .iter()
        .filter(|grade| grade.is_complete())
        .count();
    let body = html! {
        h1 { (title) @if !class.course.term.is_empty() { ", " (Untrusted::from(class.course.term.as_str())) } }
        p { (class.grades.len()) " hand-ins, " (complete) " graded in full; " (points(mean(&class.grades))) " of "
            (points(class.course.reachable())) " points on average. Made " (class.when) " by raybook " (env!("CARGO_PKG_VERSION"))
            " with the key " code { (class.key) } ". " a href="grades.csv" { "grades.csv" } ", " a href="items.csv" { "items.csv" } ", "
            a href="similar.csv" { "similar.csv" } }
        (items(class))
        (similar(class))
        (students(class))
    };
    html::page(&format!("{title}: the class"), &body)
}

fn mean(grades: &[Grade]) -> f64 {
    let sum: f64 = grades.iter().map(Grade::points).sum();
    sum / grades.len().max(1) as f64
}

fn items(class: &Class<'_>) -> Markup {
    /// The number of cases, and of mistakes, that are shown for an exercise; `items.csv` has all.
    const SHOWN: usize = 3;
    let most = |counts: &[(String, usize)]| {
        html! { @for (name, count) in counts.iter().take(SHOWN) { (Untrusted::from(name.as_str())) ": " (count) br; } }
    };
    let row = |item: &Item| {
        html! { tr {
            td { code { (item.exercise) } }
            @for standing in [Standing::Right, Standing::Wrong, Standing::NotStarted, Standing::NotBuilt, Standing::NotGraded] {
                td { (item.count(standing)) }
            }
            td { (item.visible_only) }
            td { (item.taken) }
            td style="text-align:left" { (most(&item.mistakes)) }
            td style="text-align:left" { (most(&item.cases)) }
        } }
    };
    html! { section {
        h2 { "What the class gets wrong" }
        (html::table("What the class gets wrong", &html! {
            tr { th { "exercise" } th { "right" } th { "wrong" } th { "not started" } th { "does not compile" } th { "not graded" }
                th { "right on visible cases only" } th { "reference taken" } th { "most common mistakes" } th { "cases most often wrong" } }
            @for item in &class.items { (row(item)) }
        }))
    } }
}

fn similar(class: &Class<'_>) -> Markup {
    html! { section {
        h2 { "Nearly identical hand-ins" }
        @if class.pairs.is_empty() { p { "None." } } @else {
            p { "How much of the smaller hand-in is in the other, names, comments and the starter left out. It is a reason to look, and no proof." }
            (html::table("Nearly identical hand-ins", &html! {
                tr { th { "student" } th { "student" } th { "alike" } }
                @for pair in class.pairs { tr {
                    @for student in &pair.students { td { (link(student)) } }
                    td { (format!("{:.0} %", 100.0 * pair.share)) }
                } }
            }))
        }
    } }
}

fn students(class: &Class<'_>) -> Markup {
    let row = |grade: &Grade| {
        html! { tr {
            td { (link(&grade.sheet.student)) }
            td { (points(grade.points())) }
            @for chapter in &grade.chapters { td { (points(chapter.points())) } }
            td style="text-align:left" {
                @if let Err(why) = &grade.sheet.print { "refused: " (Untrusted::from(why.as_str())) }
                @else if !grade.is_complete() { "not graded in full" }
                @for remark in remarks(grade) { (remark) br; }
            }
        } }
    };
    html! { section {
        h2 { "Students" }
        (html::table("Students", &html! {
            tr { th { "student" } th { "points" }
                @for plan in &class.course.chapters { th { (plan.chapter.title) } } th { "" } }
            @for grade in &class.grades { (row(grade)) }
        }))
    } }
}

/// What an instructor may want to look at: days late, a text that reaches for what no exercise needs, exercises that are right in the
/// visible cases only.
fn remarks(grade: &Grade) -> Vec<String> {
    let tries: Vec<_> = grade.sheet.tries.iter().map(String::as_str).collect();
    let tries =
        (!tries.is_empty()).then(|| format!("its text seems to try to {}", tries.join(", ")));
    let visible_only = grade.exercises().filter(|exercise| {
        let result = exercise.result.as_ref();
        result.is_some_and(Marked::right_on_visible_only)
    });
    let visible_only: Vec<_> = visible_only.map(|exercise| exercise.counted.name).collect();
    let visible_only = (!visible_only.is_empty()).then(|| {
        let names = visible_only.join(", ");
        format!("right on the visible cases only: {names}")
    });
    let late = grade.chapters.iter().map(|chapter| chapter.days_late).max();
    let late = late.filter(|&days| days > 0).map(|days| {
        let days_late = if days == 1 { "day" } else { "days" };
        format!("{days} {days_late} late")
    });
    late.into_iter().chain(tries).chain(visible_only).collect()
}

/// A student's name, which leads to the student's page.
fn link(student: &str) -> Markup {
    html! { a href=(format!("{STUDENTS}/{}/index.html", address::encoded(student))) { (Untrusted::from(student)) } }
}
