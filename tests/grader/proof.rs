//! How good the grader is, as a table that the book shows lecturers: of each exercise's mistakes, how many are caught and named.
//!
//! `RAYBOOK_BLESS=1 cargo test -p raybook-grader --test grader proof` writes `golden/measured/proof.md` anew.

use raybook_common::{STALE, measured};
use raybook_grader::cases;
use raybook_grader::diagnose::diagnose;
use raybook_grader::examine::{Case, Examiner, visible_rng};
use raybook_grader::hidden::Key;
use rayon::prelude::*;
use std::fmt::Write;

/// Number of students whose hidden cases are asked.
const KEYS: usize = 20;

/// After this number of wrong random answers, the share of questions on which a mistake shows is known well enough.
const ENOUGH: u32 = 3;

/// What became of the mistakes of an exercise.
struct Proof {
    name: &'static str,
    mistakes: usize,
    /// Fail for every key.
    caught: usize,
    /// Are told by their own name from the answers to the visible cases.
    named: usize,
    /// Are told by another name, and for certain.
    falsely: usize,
    /// The share of random questions on which the rarest mistake shows; all of them are caught.
    rarest: f64,
}

impl Proof {
    fn of(examiner: &dyn Examiner) -> Self {
        let visible = examiner.cases(&mut visible_rng(examiner.name())).cases;
        let hidden: Vec<_> = (0..KEYS).map(|key| hidden(examiner, key)).collect();
        let mut proof = Self {
            name: examiner.name(),
            mistakes: 0,
            caught: 0,
            named: 0,
            falsely: 0,
            rarest: 1.0,
        };
        for (i, (name, _)) in examiner.mistakes().into_iter().enumerate() {
            proof.mistakes += 1;
            let fails = |cases: &Vec<Case>| cases.iter().any(|case| !passes(examiner, i, case));
            proof.caught += usize::from(hidden.iter().all(fails));
            let answer = |case: &Case| {
                let right = passes(examiner, i, case);
                (examiner.mistaken(i, &case.question), right)
            };
            let answers: Vec<_> = visible.iter().map(answer).collect();
            let found = diagnose(examiner, &visible, &answers);
            let own = found.as_ref().is_some_and(|found| found.name == name);
            proof.named += usize::from(own);
            proof.falsely += usize::from(!own && found.is_some_and(|found| found.certain));
            proof.rarest = proof.rarest.min(share(examiner, i, &hidden));
        }
        proof
    }

    fn row(&self) -> String {
        let Self {
            name,
            mistakes,
            caught,
            named,
            falsely,
            rarest,
        } = self;
        let rarest = 100.0 * rarest;
        format!("| `{name}` | {mistakes} | {caught} | {named} | {falsely} | {rarest:.1} % |")
    }
}

/// The share of random questions that mistake number i answers wrong, counted until some are.
fn share(examiner: &dyn Examiner, i: usize, hidden: &[Vec<Case>]) -> f64 {
    let random = hidden.iter().flatten();
    let random = random.filter(|case| case.name.starts_with("random "));
    let (mut asked, mut wrong) = (0_u32, 0_u32);
    for case in random {
        asked += 1;
        wrong += u32::from(!passes(examiner, i, case));
        if wrong == ENOUGH {
            break;
        }
    }
    // It shows in a named case only: then it is rarer than one more question would have told.
    f64::from(wrong.max(1)) / f64::from(asked)
}

fn hidden(examiner: &dyn Examiner, student: usize) -> Vec<Case> {
    let key = Key {
        course: "a course's secret".into(),
        term: "autumn".into(),
        student: format!("student {student}"),
    };
    examiner.cases(&mut key.rng(examiner.name())).cases
}

/// Whether a mistake gets a case right, by luck.
fn passes(examiner: &dyn Examiner, mistake: usize, case: &Case) -> bool {
    let answer = examiner.mistaken(mistake, &case.question);
    answer.is_some_and(|answer| {
        examiner
            .judge(&case.question, &case.answers, &answer)
            .is_ok()
    })
}

fn table(proofs: &[Proof]) -> String {
    let sum = |of: fn(&Proof) -> usize| proofs.iter().map(of).sum::<usize>();
    let (mistakes, caught) = (sum(|p| p.mistakes), sum(|p| p.caught));
    let (named, falsely) = (sum(|p| p.named), sum(|p| p.falsely));
    let mut table = String::from(
        "| exercise | mistakes | caught | named | named falsely, for certain | rarest that is caught |\n|---|---|---|---|---|---|\n",
    );
    for proof in proofs {
        let _ = writeln!(table, "{}", proof.row());
    }
    let _ = writeln!(
        table,
        "| **all** | {mistakes} | {caught} | {named} | {falsely} | |"
    );
    table
}

#[test]
fn the_table_of_mistakes_caught_and_named_is_that_of_today() {
    let proofs: Vec<_> = cases::all().par_iter().map(|e| Proof::of(*e)).collect();
    let today = table(&proofs);
    assert_eq!(measured("proof", &today), today, "{STALE}");
}
