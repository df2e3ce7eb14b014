//! How rare a fault may be to be met by further random questions.

use super::{ASKED, Asked};
use raybook_common::{STALE, measured};
use raybook_grader::examine::{Case, RANDOM_CASES};
use raybook_grader::rare::{Depth, smallest_region};
use rayon::prelude::*;
use std::fmt::Write;
use std::hash::{DefaultHasher, Hash, Hasher};

/// Whether a question is in a region of this share of all questions: one of those that the number names.
fn is_in_region(question: &[f64], share: f64, number: usize) -> bool {
    let mut hasher = DefaultHasher::new();
    number.hash(&mut hasher);
    for number in question {
        number.to_bits().hash(&mut hasher);
    }
    (hasher.finish() as f64) < share * 2.0_f64.powi(64)
}

/// Of the keys' students with a fault in a region of these shares of the smallest one that the table tells, whose fault is met.
fn met<const N: usize>(asked: &Asked, shares: [f64; N]) -> [usize; N] {
    let examiner = asked.examiner;
    let mut met = [0; N];
    for (key, cases) in asked.hidden.iter().enumerate() {
        let further = examiner.rare_questions(cases, Depth::Grade);
        let smallest = smallest_region(RANDOM_CASES + further.len());
        let read = |case: &Case| {
            let question = examiner.asked().read_question(&case.question);
            question.expect("a case is a question")
        };
        let cases: Vec<_> = cases.iter().map(read).collect();
        for (met, share) in met.iter_mut().zip(shares) {
            let in_region = |question: &Vec<f64>| is_in_region(question, share * smallest, key);
            let is_fault = |question| in_region(question) && examiner.is_fault(question);
            let is_met = cases.iter().any(in_region) || further.iter().any(is_fault);
            *met += usize::from(is_met);
        }
    }
    met
}

#[test]
fn faults_in_the_region_of_the_table_are_met_with_95_percent_and_in_a_tenth_of_it_seldom() {
    let met = |asked: &Asked| met(asked, [1.0, 0.1]);
    let sum = |one: [usize; 2], other: [usize; 2]| [one[0] + other[0], one[1] + other[1]];
    let met = ASKED.par_iter().map(met).reduce(|| [0, 0], sum);
    let all: usize = ASKED.iter().map(|asked| asked.hidden.len()).sum();
    println!("{met:?} of {all} faults are met");
    let [whole, tenth] = met.map(|met| met as f64 / all as f64);
    // The standard deviation is 0.6 %.
    assert!((0.93..0.97).contains(&whole), "{whole}");
    // 1 − 0.05^0.1 = 26 %.
    assert!((0.2..0.32).contains(&tenth), "{tenth}");
}

#[test]
fn the_table_of_the_smallest_faults_that_are_met_is_that_of_today() {
    let mut table = String::from(
        "| exercise | further questions of `raybook check` | a fault in this share is met | further questions when a class is graded | a fault in this share is met |\n|---|---|---|---|---|\n",
    );
    let mut within = 0;
    for Asked {
        examiner, visible, ..
    } in &*ASKED
    {
        let counts = [Depth::Check, Depth::Grade].map(|depth| examiner.rare_count(visible, depth));
        let [check, grade] = counts.map(|count| 100.0 * smallest_region(RANDOM_CASES + count));
        within += usize::from(grade <= 0.1);
        let [few, many] = counts;
        let name = examiner.name();
        let _ = writeln!(
            table,
            "| `{name}` | {few} | {check:.1} % | {many} | {grade:.1} % |"
        );
    }
    assert_eq!(measured("rare", &table), table, "{STALE}");
    assert!(within >= 45, "{within} exercises meet a fault on 10⁻³");
}
