//! JUnit's XML, as continuous integration reads it: a suite for each student, a case for each exercise.

use super::words;
use crate::class::grades::{ExerciseGrade, Grade};
use crate::class::record::Standing;
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

/// How an exercise counts in the suite.
#[derive(PartialEq)]
enum Outcome {
    Passed,
    Skipped,
    Failed,
    Error,
}

fn outcome(grade: &Grade, exercise: &ExerciseGrade) -> Outcome {
    match exercise.result.as_ref().map(|result| result.standing) {
        Some(Standing::Right) => Outcome::Passed,
        Some(Standing::NotStarted) => Outcome::Skipped,
        Some(Standing::Wrong | Standing::NotBuilt) => Outcome::Failed,
        // A hand-in that is refused fails; what could not be graded is an error of the grader.
        None if grade.sheet.print.is_err() => Outcome::Failed,
        Some(Standing::NotGraded) | None => Outcome::Error,
    }
}

fn suite(grade: &Grade) -> Markup {
    let count = |of: Outcome| {
        grade
            .exercises()
            .filter(|exercise| outcome(grade, exercise) == of)
            .count()
    };
    html! {
        testsuite name=(Untrusted::from(grade.sheet.student.as_str())) tests=(grade.exercises().count())
            failures=(count(Outcome::Failed)) errors=(count(Outcome::Error)) skipped=(count(Outcome::Skipped)) time="0" {
            @for chapter in &grade.chapters { @for exercise in &chapter.exercises {
                testcase classname=(chapter.name) name=(exercise.counted.name) time="0" { (told(grade, exercise)) }
            } }
        }
    }
}

fn told(grade: &Grade, exercise: &ExerciseGrade) -> Markup {
    let why = grade
        .sheet
        .print
        .as_ref()
        .err()
        .cloned()
        .unwrap_or_else(|| words(exercise));
    let why = Untrusted::from(why);
    match outcome(grade, exercise) {
        Outcome::Passed => html! {},
        Outcome::Skipped => html! { skipped {} },
        Outcome::Failed => html! { failure message=(why) {} },
        Outcome::Error => html! { error message=(why) {} },
    }
}
