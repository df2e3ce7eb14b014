//! The diagnosis of a function that is written here, from the numbers of a question to those of an answer.

use glam::DVec3;
use raybook_grader::cases;
use raybook_grader::diagnose::{Diagnosis, diagnose};
use raybook_grader::examine::{Case, Examiner, visible_rng};
use raybook_grader::explain::find;
use raybook_grader::explain::way::Way;
use raybook_workbook::row;

/// The diagnosis of a function; `None` is no answer.
pub fn diagnosed(exercise: &str, function: impl Fn(&[f64]) -> Option<Vec<f64>>) -> Diagnosis {
    found(exercise, function).expect("it has a name")
}

/// The same, if there is anything to say.
pub fn found(exercise: &str, function: impl Fn(&[f64]) -> Option<Vec<f64>>) -> Option<Diagnosis> {
    let examiner = cases::find(exercise).expect("the exercise exists");
    let cases = examiner.cases(&mut visible_rng(exercise)).cases;
    diagnose(examiner, &cases, &answers(examiner, &cases, function))
}

/// The answers of a function to these cases, and whether they are right.
pub fn answers(
    examiner: &dyn Examiner,
    cases: &[Case],
    function: impl Fn(&[f64]) -> Option<Vec<f64>>,
) -> Vec<(Option<String>, bool)> {
    let asked = examiner.asked();
    let answer = |case: &Case| {
        let question = asked.read_question(&case.question).expect("a question");
        let Some(answer) = function(&question) else {
            return (None, false);
        };
        let answer = row::format(asked.answer.kind, &answer);
        let verdict = examiner.judge(&case.question, &case.answers, &answer);
        (Some(answer), verdict.is_ok())
    };
    cases.iter().map(answer).collect()
}

/// The right answer to a question.
pub fn right(exercise: &str, question: &[f64]) -> Vec<f64> {
    let examiner = cases::find(exercise).expect("the exercise exists");
    (examiner.asked().call)(question)
}

/// The same on the way that is explained, in double precision.
pub fn told(exercise: &str, question: &[f64]) -> Vec<f64> {
    let explainer = find(exercise).expect("it has steps");
    (explainer.work)(0, question, &mut Way::default())
}

/// A question of `camera_ray`: the focal point, forward, right and up; the focal length, the plane's width and height, and x and y of the film.
pub fn camera(question: &[f64]) -> ([DVec3; 4], [f64; 5]) {
    (
        [0, 3, 6, 9].map(|from| DVec3::from_slice(&question[from..])),
        [12, 13, 14, 15, 16].map(|i| question[i]),
    )
}
