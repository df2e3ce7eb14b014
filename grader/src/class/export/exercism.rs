//! `results.json`, as Exercism reads it from a test runner (<https://exercism.org/docs/building/tooling/test-runners/interface>, version 3).

use super::outcome::{Status, outcome, visible, why};
use crate::class::grades::{ExerciseGrade, Grade};
use crate::class::record::Standing;
use raybook_workbook::curriculum;
use serde_json::{Map, Value, json};

/// The results of a hand-in. Each exercise is a test; the task is its chapter.
pub fn results(grade: &Grade) -> Value {
    let tests: Vec<_> = grade
        .exercises()
        .map(|exercise| test(grade, exercise))
        .collect();
    let all = |status: &str| tests.iter().all(|test| test["status"] == status);
    let status = match () {
        () if all("pass") => "pass",
        () if all("error") => "error",
        () => "fail",
    };
    // Only where no test ran is there a message above the tests: the first one says why.
    let message = tests.first().filter(|_| status == "error");
    let message = message.map(|test| test["message"].clone());
    json!({ "version": 3, "status": status, "message": message, "tests": tests })
}

fn test(grade: &Grade, exercise: &ExerciseGrade) -> Value {
    let name = exercise.counted.name;
    let outcome = outcome(grade, exercise);
    let standing = exercise.result.as_ref().map(|result| result.standing);
    let ran = !matches!(
        standing,
        None | Some(Standing::NotBuilt | Standing::NotGraded)
    );
    let status = match outcome {
        Status::Passed => "pass",
        Status::Skipped | Status::Failed if ran => "fail",
        _ => "error",
    };
    let mut test = Map::new();
    test.insert("name".to_owned(), json!(name));
    test.insert("status".to_owned(), json!(status));
    // How a student runs the same test.
    test.insert(
        "test_code".to_owned(),
        json!(format!("raybook check {name}")),
    );
    if outcome != Status::Passed {
        let message = visible(&why(grade, exercise));
        test.insert("message".to_owned(), json!(message));
    }
    if let Some(chapter) = curriculum::of_exercise(name) {
        test.insert("task_id".to_owned(), json!(chapter.number()));
    }
    Value::Object(test)
}
