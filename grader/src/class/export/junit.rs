//! JUnit's XML, as continuous integration reads it: a suite for each student, a case for each exercise.

use super::outcome::{Status, outcome, why};
use crate::class::grades::{ExerciseGrade, Grade};
use crate::class::roll::Class;
use maud::{Markup, PreEscaped, html};
use raybook_chapters::kit::untrusted::Untrusted;

/// The report of a class.
pub fn report(class: &Class<'_>) -> String {
    let report = html! {
        (PreEscaped("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"))
        testsuites name=(Untrusted::from(class.course.title.as_str())) {
            @for grade in &class.grades { (suite(grade)) }
        }
    };
    report.into_string() + "\n"
}

fn suite(grade: &Grade) -> Markup {
    let count = |of: Status| {
        grade
            .exercises()
            .filter(|exercise| outcome(grade, exercise) == of)
            .count()
    };
    html! {
        testsuite name=(Untrusted::from(grade.sheet.student.as_str())) tests=(grade.exercises().count())
            failures=(count(Status::Failed)) errors=(count(Status::Error)) skipped=(count(Status::Skipped)) time="0" {
            @for chapter in &grade.chapters { @for exercise in &chapter.exercises {
                testcase classname=(chapter.name) name=(exercise.counted.name) time="0" { (told(grade, exercise)) }
            } }
        }
    }
}

fn told(grade: &Grade, exercise: &ExerciseGrade) -> Markup {
    let why = Untrusted::from(why(grade, exercise));
    match outcome(grade, exercise) {
        Status::Passed => html! {},
        Status::Skipped => html! { skipped {} },
        Status::Failed => html! { failure message=(why) {} },
        Status::Error => html! { error message=(why) {} },
    }
}
