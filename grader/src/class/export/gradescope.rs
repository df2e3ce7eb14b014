//! `results.json`, as Gradescope reads it (<https://gradescope-autograders.readthedocs.io/en/latest/specs/>).

use super::outcome::visible;
use super::words;
use crate::class::grades::{ChapterGrade, ExerciseGrade, Grade};
use crate::class::record::Standing;
use raybook_chapters::kit::untrusted::Untrusted;
use serde_json::{Value, json};

/// The results of a hand-in. Each exercise is a test; the score is what the course's rules make of them.
pub fn results(grade: &Grade) -> Value {
    let tests: Vec<_> = grade
        .chapters
        .iter()
        .flat_map(|chapter| {
            chapter
                .exercises
                .iter()
                .map(move |exercise| test(chapter, exercise))
        })
        .collect();
    let output = match &grade.sheet.print {
        Err(why) => format!(
            "The hand-in cannot be graded: {}",
            Untrusted::from(why.as_str())
        ),
        Ok(_) if !grade.is_complete() => {
            "Not everything could be graded; ask your instructor.".to_owned()
        }
        Ok(_) => String::new(),
    };
    json!({ "score": grade.points(), "output": output, "visibility": "visible", "stdout_visibility": "hidden", "tests": tests })
}

fn test(chapter: &ChapterGrade, exercise: &ExerciseGrade) -> Value {
    let counts = chapter.weight * (1.0 - chapter.lost);
    let is_right = exercise
        .result
        .as_ref()
        .is_some_and(|result| result.standing == Standing::Right);
    // A bonus is on top of what can be reached.
    let most = if exercise.counted.bonus {
        0.0
    } else {
        chapter.weight * exercise.counted.points
    };
    json!({
        "name": exercise.counted.name, "number": chapter.name, "score": counts * exercise.points.unwrap_or(0.0), "max_score": most,
        "status": if is_right { "passed" } else { "failed" }, "output": visible(&words(exercise)), "output_format": "text",
        "visibility": "visible",
    })
}
