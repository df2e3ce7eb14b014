//! What becomes of an exercise in the reports that machines read.

use super::words;
use crate::class::grades::{ExerciseGrade, Grade};
use crate::class::record::Standing;
use raybook_chapters::kit::untrusted::Untrusted;

/// How an exercise counts in a report.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// It is right.
    Passed,
    /// It is not written yet.
    Skipped,
    /// It is wrong, does not compile, or is in a hand-in that is refused.
    Failed,
    /// It could not be graded, which is no fault of the hand-in.
    Error,
}

/// The outcome of an exercise of a hand-in.
pub fn outcome(grade: &Grade, exercise: &ExerciseGrade) -> Status {
    match exercise.result.as_ref().map(|result| result.standing) {
        Some(Standing::Right) => Status::Passed,
        Some(Standing::NotStarted) => Status::Skipped,
        Some(Standing::Wrong | Standing::NotBuilt) => Status::Failed,
        None if grade.sheet.print.is_err() => Status::Failed,
        Some(Standing::NotGraded) | None => Status::Error,
    }
}

/// Why the hand-in is refused, or else what is told of the exercise.
pub fn why(grade: &Grade, exercise: &ExerciseGrade) -> String {
    let refused = grade.sheet.print.as_ref().err();
    refused.cloned().unwrap_or_else(|| words(exercise))
}

/// Text of several lines, with everything in it visible but the line ends.
pub fn visible(text: &str) -> String {
    let lines: Vec<_> = text
        .lines()
        .map(|line| Untrusted::from(line).to_string())
        .collect();
    lines.join("\n")
}
