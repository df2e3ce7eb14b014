//! How good the grader is, as tables that the book shows lecturers: of each exercise's mistakes, how many are caught and named, and how rare a
//! fault may be to be met.
//!
//! `RAYBOOK_BLESS=1 cargo test -p raybook-grader --test grader proof` writes `golden/measured/proof.md`, `equivalent.md` and `rare.md` anew.

mod equivalent;
mod rare;

use crate::trial::tried;
use equivalent::EQUIVALENT;
use raybook_common::{STALE, measured};
use raybook_grader::cases;
use raybook_grader::examine::{Case, Examiner, visible_rng};
use raybook_grader::hidden::Key;
use rayon::prelude::*;
use std::fmt::Write;
use std::sync::LazyLock;

/// Number of students whose hidden cases are asked.
const KEYS: usize = 20;

/// After this number of wrong random answers, the share of questions on which a mistake shows is known well enough.
const ENOUGH: u32 = 3;

/// An exercise with its cases.
struct Asked {
    examiner: &'static dyn Examiner,
    visible: Vec<Case>,
    /// The random cases of each key. The named ones are those that are visible.
    hidden: Vec<Vec<Case>>,
}

static ASKED: LazyLock<Vec<Asked>> = LazyLock::new(|| {
    let asked = |examiner: &'static dyn Examiner| Asked {
        examiner,
        visible: examiner.cases(&mut visible_rng(examiner.name())).cases,
        hidden: (0..KEYS).map(|key| hidden(examiner, key)).collect(),
    };
    cases::all().into_par_iter().map(asked).collect()
});

fn hidden(examiner: &dyn Examiner, student: usize) -> Vec<Case> {
    let key = Key {
        course: "a course's secret".into(),
        term: "autumn".into(),
        student: format!("student {student}"),
    };
    let cases = examiner.try_random_cases(&mut key.rng(examiner.name()));
    cases.expect("the reference answers").cases
}

/// What became of the mistakes of an exercise.
struct Proof {
    name: &'static str,
    mistakes: usize,
    /// Who passes the visible cases, or those of some key.
    escaped: Vec<String>,
    /// Who is told another name than the mistake's own, or none, after the trial.
    misnamed: Vec<String>,
    /// Are told by their own name, and for certain.
    certainly: usize,
    /// Are told by another name, and for certain.
    falsely: usize,
    /// The share of random questions on which the rarest mistake shows; all of them are caught.
    rarest: f64,
}

impl Proof {
    fn of(asked: &Asked) -> Self {
        let (examiner, visible) = (asked.examiner, &asked.visible);
        let mut proof = Self {
            name: examiner.name(),
            mistakes: 0,
            escaped: Vec::new(),
            misnamed: Vec::new(),
            certainly: 0,
            falsely: 0,
            rarest: 1.0,
        };
        for (i, (name, _)) in examiner.mistakes().into_iter().enumerate() {
            proof.mistakes += 1;
            let who = || format!("{}: who {name}", proof.name);
            let answer = |case: &Case| {
                let answer = examiner.mistaken(i, &case.question);
                let right = is_right(examiner, case, answer.as_deref());
                (answer, right)
            };
            let answers: Vec<_> = visible.iter().map(answer).collect();
            let wrong = |(case, (_, right)): (&Case, &(_, bool))| !right && !case.is_random();
            let fails_a_named_case = visible.iter().zip(&answers).any(wrong);
            let fails = |cases: &Vec<Case>| cases.iter().any(|case| !passes(examiner, i, case));
            let fails_visibly = answers.iter().any(|(_, right)| !right);
            if !fails_visibly || !fails_a_named_case && !asked.hidden.iter().all(fails) {
                proof.escaped.push(who());
            }
            let found = tried(examiner, visible, answer);
            let is_certain = found.as_ref().is_some_and(|found| found.certain);
            if found.as_ref().is_none_or(|found| found.name != name) {
                let told = found.as_ref().map(|found| &found.name);
                proof.misnamed.push(format!("{}: {told:?}", who()));
                proof.falsely += usize::from(is_certain);
            } else {
                proof.certainly += usize::from(is_certain);
            }
            proof.rarest = proof.rarest.min(share(examiner, i, &asked.hidden));
        }
        proof
    }

    fn equivalent(&self) -> usize {
        let own = EQUIVALENT.iter().filter(|one| one.exercise == self.name);
        own.count()
    }

    fn caught(&self) -> usize {
        self.mistakes - self.escaped.len()
    }

    fn named(&self) -> usize {
        self.mistakes - self.misnamed.len()
    }

    fn row(&self) -> String {
        let Self {
            name,
            mistakes,
            certainly,
            falsely,
            ..
        } = self;
        let (caught, named, same) = (self.caught(), self.named(), self.equivalent());
        let rarest = 100.0 * self.rarest;
        format!(
            "| `{name}` | {mistakes} | {caught} | {named} | {certainly} | {falsely} | {same} | {rarest:.1} % |"
        )
    }
}

/// The share of random questions that mistake number i answers wrong, counted until some are.
fn share(examiner: &dyn Examiner, i: usize, hidden: &[Vec<Case>]) -> f64 {
    let (mut asked, mut wrong) = (0_u32, 0_u32);
    for case in hidden.iter().flatten() {
        asked += 1;
        wrong += u32::from(!passes(examiner, i, case));
        if wrong == ENOUGH {
            break;
        }
    }
    // It shows in a named case only: then it is rarer than one more question would have told.
    f64::from(wrong.max(1)) / f64::from(asked)
}

/// Whether a mistake gets a case right, by luck.
fn passes(examiner: &dyn Examiner, mistake: usize, case: &Case) -> bool {
    let answer = examiner.mistaken(mistake, &case.question);
    is_right(examiner, case, answer.as_deref())
}

fn is_right(examiner: &dyn Examiner, case: &Case, answer: Option<&str>) -> bool {
    let verdict = |got| examiner.judge(&case.question, &case.answers, got);
    answer.is_some_and(|got| verdict(got).is_ok())
}

static PROOFS: LazyLock<Vec<Proof>> = LazyLock::new(|| ASKED.par_iter().map(Proof::of).collect());

fn table(proofs: &[Proof]) -> String {
    let sum = |of: fn(&Proof) -> usize| proofs.iter().map(of).sum::<usize>();
    let (mistakes, caught) = (sum(|p| p.mistakes), sum(Proof::caught));
    let named = sum(Proof::named);
    let (certainly, falsely) = (sum(|p| p.certainly), sum(|p| p.falsely));
    let same = sum(Proof::equivalent);
    let mut table = String::from(
        "| exercise | mistakes | caught | named | for certain | falsely, for certain | equivalent | rarest that is caught |\n|---|---|---|---|---|---|---|---|\n",
    );
    for proof in proofs {
        let _ = writeln!(table, "{}", proof.row());
    }
    let _ = writeln!(
        table,
        "| **all** | {mistakes} | {caught} | {named} | {certainly} | {falsely} | {same} | |"
    );
    table
}

#[test]
fn every_mistake_fails_a_visible_case_and_a_hidden_one_for_every_key() {
    let escaped: Vec<_> = PROOFS.iter().flat_map(|proof| &proof.escaped).collect();
    assert!(escaped.is_empty(), "{escaped:#?}");
}

#[test]
fn every_mistake_is_diagnosed_as_itself() {
    let misnamed: Vec<_> = PROOFS.iter().flat_map(|proof| &proof.misnamed).collect();
    assert!(misnamed.is_empty(), "{misnamed:#?}");
}

#[test]
fn the_table_of_mistakes_caught_and_named_is_that_of_today() {
    let today = table(&PROOFS);
    assert_eq!(measured("proof", &today), today, "{STALE}");
}
