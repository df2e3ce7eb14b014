//! The smallest wrong question: rounder, shorter, and as wrong as the one it comes from.

use raybook_grader::ask::{Reply, Said};
use raybook_grader::cases;
use raybook_grader::check::{Mark, Outcome};
use raybook_grader::converse::Prints;
use raybook_grader::examine::{Examiner, visible_rng};
use raybook_grader::shrink::smallest;
use rayon::prelude::*;
use std::cell::Cell;

/// How many mistakes of an exercise are tried.
const MISTAKES: usize = 2;

/// What a program with mistake number i replies.
fn mistaken(examiner: &dyn Examiner, i: usize, question: &str) -> Reply {
    let answer = examiner.mistaken(i, question).expect("it is a question");
    Reply {
        said: Said::Answer(answer.into()),
        printed: Prints::default(),
    }
}

/// The first random case that mistake number i answers wrong.
fn wrong(examiner: &dyn Examiner, i: usize) -> Option<Outcome> {
    let cases = examiner.cases(&mut visible_rng(examiner.name())).cases;
    let random = cases
        .into_iter()
        .filter(|case| case.name.starts_with("random"));
    let mut outcomes = random.map(|case| {
        let reply = mistaken(examiner, i, &case.question);
        let Said::Answer(answer) = &reply.said else {
            unreachable!("a mistake answers");
        };
        let judged = examiner.judge(&case.question, &case.answers, answer.unescaped());
        Outcome {
            verdict: judged.map_or_else(Mark::Wrong, |()| Mark::Right),
            case,
            reply,
        }
    });
    outcomes.find(|outcome| outcome.verdict != Mark::Right)
}

/// The smallest question that is as wrong, and how many were asked on the way.
fn shrunk(examiner: &dyn Examiner, i: usize, outcome: &Outcome) -> (Option<Outcome>, usize) {
    let asked = Cell::new(0);
    let mut ask = |questions: &[String]| {
        asked.set(asked.get() + questions.len());
        let reply = |question: &String| {
            let row = question.strip_prefix(examiner.name()).expect("its name");
            mistaken(examiner, i, row)
        };
        Ok(questions.iter().map(reply).collect())
    };
    let found = smallest(&mut ask, examiner, outcome, None).expect("it can be asked");
    (found, asked.get())
}

/// The smallest wrong questions of all exercises, for their first mistakes.
pub fn smallest_questions() -> Vec<(&'static dyn Examiner, Vec<Outcome>)> {
    let all = cases::all().into_par_iter().map(|examiner| {
        let mistakes = 0..examiner.mistakes().len().min(MISTAKES);
        let found = mistakes.filter_map(|i| shrunk(examiner, i, &wrong(examiner, i)?).0);
        (examiner, found.collect())
    });
    all.collect()
}

fn digits(row: &str) -> usize {
    row.chars().filter(char::is_ascii_digit).count()
}

#[test]
fn a_wrong_question_is_made_smaller() {
    let simpler: Vec<_> = cases::all()
        .into_par_iter()
        .filter(|examiner| {
            let name = examiner.name();
            let Some(outcome) = wrong(*examiner, 0) else {
                return false;
            };
            let (found, asked) = shrunk(*examiner, 0, &outcome);
            assert!(asked <= 200, "{name}: {asked} questions are asked");
            let Some(found) = found else { return false };
            assert_eq!(found.case.number, outcome.case.number, "{name}");
            assert!(matches!(found.verdict, Mark::Wrong(_)), "{name}");
            assert!(
                digits(&found.case.question) < digits(&outcome.case.question),
                "{name}: {}",
                found.case.question
            );
            let again = shrunk(*examiner, 0, &outcome).0;
            assert_eq!(again, Some(found), "{name}: the same each time");
            true
        })
        .collect();
    assert!(simpler.len() >= 50, "only {} become simpler", simpler.len());
}

#[test]
fn a_sphere_that_is_missed_becomes_a_round_one() {
    let sphere = cases::find("sphere_hit").expect("the exercise exists");
    let outcome = wrong(sphere, 0).expect("it is wrong");
    let (found, _) = shrunk(sphere, 0, &outcome);
    let found = found.expect("it is simpler").case;
    let longest = found.question.split(' ').map(str::len).max();
    assert!(longest <= Some(4), "{}", found.question);
    assert!(found.name.starts_with(&outcome.case.name), "{}", found.name);
}

#[test]
fn what_has_no_answer_stays_as_it_is() {
    let sphere = cases::find("sphere_hit").expect("the exercise exists");
    let mut outcome = wrong(sphere, 0).expect("it is wrong");
    outcome.reply.said = Said::Ended("exit code 1".into());
    assert_eq!(shrunk(sphere, 0, &outcome), (None, 0));
}

#[test]
fn a_program_that_falls_silent_is_not_asked_on() {
    let sphere = cases::find("sphere_hit").expect("the exercise exists");
    let outcome = wrong(sphere, 0).expect("it is wrong");
    let asked = Cell::new(0);
    let mut ask = |questions: &[String]| {
        asked.set(asked.get() + 1);
        let silent = Reply {
            said: Said::Ended("exit code 1".into()),
            printed: Prints::default(),
        };
        Ok(vec![silent; questions.len()])
    };
    let found = smallest(&mut ask, sphere, &outcome, None).expect("it can be asked");
    assert_eq!((found, asked.get()), (None, 1));
}
