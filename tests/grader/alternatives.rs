//! The judges are fair: programs that are right by another method pass, and programs that are a little wrong do not.
//!
//! Everything goes by lines of text, as between `raybook check` and a student's program.

#![allow(clippy::unnecessary_wraps)] // an answer may be none, if not in every exercise

mod boxes;
mod ch11;
mod ch12;
mod ch13;
mod ch14;
mod ch15;
mod ch16;
mod ch17;
mod ch18;
mod ch19;
mod ch20;
mod ch21;
mod ch22;
mod ch23;
mod ch24;
mod ch25;
mod estimates;
mod flat;
mod grid;
mod light;
mod mesh;
mod noticed;
mod numbers;
use raybook_common::polygon;
mod sphere;
mod student;
mod together;
mod trees;
mod triangle;
mod wrong;

use raybook_grader::cases;
use raybook_grader::examine::{Case, Examiner, visible_rng};
use raybook_grader::hidden::Key;
use raybook_grader::picture::ask::{pixel_questions, triples};
use raybook_grader::rare::Depth;
use raybook_workbook::row;
use rayon::prelude::*;
use std::collections::BTreeSet;
use std::sync::LazyLock;
use student::{Alternative, STYLES, line};

/// Number of students whose hidden cases are tried; of estimates, which take long, a part.
const KEYS: usize = 100;
const KEYS_OF_ESTIMATES: usize = 20;

/// How long an answer takes that is an estimate.
const ESTIMATE: usize = 100;

/// Number of exercises that have an alternative, at least. A new one can come before it.
const WITH_ALTERNATIVES: usize = 64;

/// Whether an exercise is a hit function, which has two alternatives or more.
fn is_hit(exercise: &str) -> bool {
    ["_hit", "_clip", "_closest"]
        .iter()
        .any(|end| exercise.ends_with(end))
}

#[test]
fn programs_that_are_right_by_another_method_pass_every_case() {
    let exercises: BTreeSet<_> = alternatives().map(|other| other.exercise).collect();
    for exercise in &exercises {
        assert!(cases::find(exercise).is_some(), "there is no `{exercise}`");
    }
    assert!(
        exercises.len() >= WITH_ALTERNATIVES,
        "those that the course began with"
    );
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
    assert!(
        others.len() != 1 || !is_hit(name),
        "{name}: a hit function has two alternatives in tests/grader/alternatives"
    );
    let mut unfair = Vec::new();
    let asked = others
        .iter()
        .flat_map(|other| cases.iter().map(move |case| (other, case)));
    for (other, case) in asked {
        let answer = other.answer_to(&case.question);
        // Hidden cases are many, and one way of printing numbers is enough.
        let styles = if case.number == 0 { 1 } else { STYLES.len() };
        for (style, print) in &STYLES[..styles] {
            let got = line(&answer, *print);
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

/// A student is asked thousands of these, so of a hundred students none may meet an unfair one.
#[test]
fn programs_that_are_right_by_another_method_are_right_in_further_questions() {
    let unfair: Vec<_> = CASES
        .par_iter()
        .flat_map_iter(|(examiner, cases)| unfair_faults(*examiner, cases))
        .collect();
    assert!(unfair.is_empty(), "{}", unfair.join("\n"));
}

/// The further questions to which an alternative's answer counts as a fault.
fn unfair_faults(examiner: &dyn Examiner, cases: &[Case]) -> Vec<String> {
    let name = examiner.name();
    let kinds = examiner.asked();
    let mut unfair = Vec::new();
    for question in examiner.rare_questions(cases, Depth::Grade) {
        let golden = examiner
            .reference(&question)
            .expect("the reference answers");
        let golden = vec![row::format(kinds.answer.kind, &golden)];
        let line_of = row::format(kinds.question, &question);
        for other in alternatives().filter(|other| other.exercise == name) {
            let got = line(&other.answer_to(&line_of), STYLES[0].1);
            if let Err(why) = examiner.judge(&line_of, &golden, &got)
                && examiner.is_fault(&question)
            {
                unfair.push(format!(
                    "{name}, {}: {line_of}\n  right {golden:?}\n  got   {got}\n  {why}",
                    other.method
                ));
            }
        }
    }
    unfair
}

#[test]
fn pictures_by_another_method_are_passed() {
    // The four scenes of `trace` have a test of their own.
    let pictured = |other: &&Alternative| other.exercise != "trace";
    let others: Vec<_> = alternatives().filter(pictured).collect();
    let drawn = others.into_par_iter().map(|other| {
        let examiner = cases::find(other.exercise).expect("it is an exercise");
        let answer = |question: &String| Some(line(&other.answer_to(question), STYLES[0].1));
        let answers: Vec<_> = pixel_questions(examiner).iter().map(answer).collect();
        for picture in triples(examiner, &answers) {
            assert!(
                picture.score.passed(),
                "{}, {}: {:?}, {:?}",
                other.exercise,
                other.method,
                picture.score,
                picture.first_bad
            );
        }
        usize::from(!answers.is_empty())
    });
    assert!(drawn.sum::<usize>() >= 30, "pictures by other methods");
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

/// Every exercise with its visible cases, what follows from these, and the random ones of some students, which have no numbers.
static CASES: LazyLock<Vec<(&dyn Examiner, Vec<Case>)>> = LazyLock::new(|| {
    let all = |examiner: &dyn Examiner| {
        let name = examiner.name();
        let mut cases = examiner.cases(&mut visible_rng(name)).cases;
        let followers = examiner.followers(&cases).into_iter();
        let follow: Vec<_> = followers.map(|one| one.case).collect();
        cases.extend(follow);
        let keys = if examiner.limits().effort < ESTIMATE {
            KEYS
        } else {
            KEYS_OF_ESTIMATES
        };
        for student in 0..keys {
            let key = Key {
                course: "another course's secret".into(),
                term: "spring".into(),
                student: format!("student {student}"),
            };
            let random = examiner.try_random_cases(&mut key.rng(name));
            cases.extend(random.expect("the reference answers").cases);
        }
        cases
    };
    let examiners = cases::all().into_par_iter();
    examiners
        .map(|examiner| (examiner, all(examiner)))
        .collect()
});
