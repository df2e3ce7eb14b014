//! The judges are fair: programs that are right by another method pass, and programs that are a little wrong do not.
//!
//! Everything goes by lines of text, as between `raybook check` and a student's program.

#![allow(clippy::unnecessary_wraps)] // an answer may be none, if not in every exercise

#[path = "alternatives/boxes.rs"]
mod boxes;
#[path = "alternatives/ch11.rs"]
mod ch11;
#[path = "alternatives/ch12.rs"]
mod ch12;
#[path = "alternatives/ch13.rs"]
mod ch13;
#[path = "alternatives/ch14.rs"]
mod ch14;
#[path = "alternatives/ch15.rs"]
mod ch15;
#[path = "alternatives/ch16.rs"]
mod ch16;
#[path = "alternatives/ch17.rs"]
mod ch17;
#[path = "alternatives/ch18.rs"]
mod ch18;
#[path = "alternatives/ch19.rs"]
mod ch19;
#[path = "alternatives/ch20.rs"]
mod ch20;
#[path = "alternatives/ch21.rs"]
mod ch21;
#[path = "alternatives/ch22.rs"]
mod ch22;
#[path = "alternatives/ch23.rs"]
mod ch23;
#[path = "alternatives/ch24.rs"]
mod ch24;
#[path = "alternatives/ch25.rs"]
mod ch25;
#[path = "alternatives/estimates.rs"]
mod estimates;
#[path = "alternatives/flat.rs"]
mod flat;
#[path = "alternatives/grid.rs"]
mod grid;
#[path = "alternatives/light.rs"]
mod light;
#[path = "alternatives/mesh.rs"]
mod mesh;
#[path = "alternatives/noticed.rs"]
mod noticed;
#[path = "alternatives/numbers.rs"]
mod numbers;
#[path = "common/polygon.rs"]
mod polygon;
#[path = "alternatives/sphere.rs"]
mod sphere;
#[path = "alternatives/student.rs"]
mod student;
#[path = "alternatives/trees.rs"]
mod trees;
#[path = "alternatives/triangle.rs"]
mod triangle;
#[path = "alternatives/wrong.rs"]
mod wrong;

use raybook::grade::cases;
use raybook::grade::examine::{Case, Examiner, visible_rng};
use raybook::grade::hidden::Key;
use rayon::prelude::*;
use std::sync::LazyLock;
use student::{Alternative, STYLES, line};

/// So many students' hidden cases are tried.
const KEYS: usize = 20;

/// Whether an exercise is a hit function, of which at least two alternatives are asked.
fn is_hit(exercise: &str) -> bool {
    ["_hit", "_clip", "_closest"]
        .iter()
        .any(|end| exercise.ends_with(end))
}

#[test]
fn programs_that_are_right_by_another_method_pass_every_case() {
    for Alternative { exercise, .. } in alternatives() {
        assert!(cases::find(exercise).is_some(), "there is no `{exercise}`");
    }
    let unfair: Vec<_> = CASES
        .par_iter()
        .flat_map_iter(|(examiner, cases)| unfair_verdicts(*examiner, cases))
        .collect();
    assert!(
        unfair.is_empty(),
        "{} right answers are called wrong, such as\n{}",
        unfair.len(),
        unfair[..unfair.len().min(10)].join("\n")
    );
}

/// The verdicts on an exercise's alternatives that call a right answer wrong.
fn unfair_verdicts(examiner: &dyn Examiner, cases: &[Case]) -> Vec<String> {
    let name = examiner.name();
    let others: Vec<_> = alternatives()
        .filter(|other| other.exercise == name)
        .collect();
    let needed = if is_hit(name) { 2 } else { 1 };
    assert!(
        others.len() >= needed,
        "{name}: {} alternatives; {needed} are needed",
        others.len()
    );
    let mut unfair = Vec::new();
    let asked = others
        .iter()
        .flat_map(|other| cases.iter().map(move |case| (other, case)));
    for (other, case) in asked {
        let answer = other.answer_to(&case.question);
        for (style, print) in STYLES {
            let got = line(&answer, print);
            if let Err(why) = examiner.judge(&case.question, &case.answers, &got) {
                unfair.push(format!(
                    "{name}, {}, numbers {style}; {}: {}\n  right {:?}\n  got   {got}\n  {why}",
                    other.method, case.name, case.question, case.answers
                ));
            }
        }
    }
    unfair
}

fn alternatives() -> impl Iterator<Item = &'static Alternative> {
    [
        light::ALTERNATIVES,
        sphere::ALTERNATIVES,
        flat::ALTERNATIVES,
        triangle::ALTERNATIVES,
        mesh::ALTERNATIVES,
        grid::ALTERNATIVES,
        trees::ALTERNATIVES,
        ch11::ALTERNATIVES,
        ch21::ALTERNATIVES,
        ch24::ALTERNATIVES,
        ch12::ALTERNATIVES,
        ch13::ALTERNATIVES,
        ch14::ALTERNATIVES,
        ch15::ALTERNATIVES,
        ch16::ALTERNATIVES,
        ch17::ALTERNATIVES,
        estimates::ALTERNATIVES,
        ch18::ALTERNATIVES,
        ch19::ALTERNATIVES,
        ch20::ALTERNATIVES,
        ch22::ALTERNATIVES,
        ch23::ALTERNATIVES,
        ch25::ALTERNATIVES,
    ]
    .into_iter()
    .flatten()
}

/// Every exercise with its visible cases, and the hidden ones of some students.
static CASES: LazyLock<Vec<(&dyn Examiner, Vec<Case>)>> = LazyLock::new(|| {
    let all = |examiner: &dyn Examiner| {
        let name = examiner.name();
        let mut cases = examiner.cases(&mut visible_rng(name)).cases;
        for student in 0..KEYS {
            let key = Key {
                course: "another course's secret".into(),
                term: "spring".into(),
                student: format!("student {student}"),
            };
            cases.extend(examiner.cases(&mut key.rng(name)).cases);
        }
        cases
    };
    let examiners = cases::all().into_par_iter();
    examiners
        .map(|examiner| (examiner, all(examiner)))
        .collect()
});
