//! What the folder's programs do.

use crate::common::starter::build;
use crate::starter::names;
use raybook_grader::ask::{Said, ask};
use raybook_grader::cases;
use raybook_grader::converse::{Limits, Program};
use raybook_grader::examine::{Case, Examiner, visible_rng};
use raybook_grader::starter::stub;
use raybook_workbook::anchor::Anchored;
use rayon::prelude::*;
use std::path::PathBuf;
use std::time::Duration;

const LIMITS: Limits = Limits::of(Duration::from_secs(10));

#[test]
fn the_untouched_starter_compiles_and_everything_is_todo() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let program = build(folder.path(), &stub);
    let asked = visible_cases();
    let all = asked
        .iter()
        .flat_map(|(examiner, cases)| cases.iter().map(|case| (*examiner, case)));
    let all: Vec<_> = all.collect();
    for ((examiner, case), said) in all.iter().zip(replies(&program, &all)) {
        assert_eq!(
            said,
            Said::Todo(examiner.name().into()),
            "{} {}: not written yet",
            examiner.name(),
            case.name
        );
    }
}

/// One build in which an environment variable says which exercise is stubbed: the same text as the stub's and the
/// reference's, without compiling once per exercise.
#[test]
fn each_exercise_stubbed_alone_is_the_only_one_that_turns_todo() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let switched = |function: &Anchored<'_>| {
        let Anchored {
            name, text, body, ..
        } = *function;
        let switch = format!(
            "if std::env::var(\"RAYBOOK_STUB\").is_ok_and(|stub| stub == \"{name}\") {{ todo!(\"{name}\") }}"
        );
        stub(function).map(|_| text.replacen(body, &format!("\n{switch}\n{body}"), 1))
    };
    let program = build(folder.path(), &switched);
    let asked = visible_cases();
    names().par_iter().enumerate().for_each(|(i, stubbed)| {
        only_this_turns_todo(&program, stubbed, i, &asked);
    });
}

/// Asks an exercise that is stubbed all its cases, and the others one in `SOME`: each stub, of which there are as many, another
/// one, so that every case is asked.
fn only_this_turns_todo(program: &Program, stubbed: &str, i: usize, asked: &[Asked]) {
    const SOME: usize = 64;
    let program = Program {
        file: PathBuf::from("env"),
        arguments: vec![
            format!("RAYBOOK_STUB={stubbed}").into(),
            program.file.clone().into(),
        ],
        folder: PathBuf::new(),
        sandbox: None,
    };
    let chosen = asked.iter().flat_map(|(examiner, cases)| {
        let own = examiner.name() == stubbed;
        let (first, step) = if own { (0, 1) } else { (i % SOME, SOME) };
        let cases = cases.iter().skip(first).step_by(step);
        cases.map(|case| (*examiner, case))
    });
    let chosen: Vec<_> = chosen.collect();
    let mut todo = 0;
    for ((examiner, case), said) in chosen.iter().zip(replies(&program, &chosen)) {
        let own = examiner.name() == stubbed;
        let whose = format!("{} {} without {stubbed}", examiner.name(), case.name);
        match said {
            Said::Todo(waits_for) => {
                assert_eq!(
                    waits_for.unescaped(),
                    stubbed,
                    "{whose}: it waits for what is stubbed"
                );
                todo += usize::from(own);
            }
            Said::Answer(answer) => {
                assert!(!own, "{whose}: what is stubbed cannot answer");
                let verdict = examiner.judge(&case.question, &case.answers, answer.unescaped());
                assert_eq!(verdict, Ok(()), "{whose}");
            }
            said => panic!("{whose}: {said:?}"),
        }
    }
    assert!(todo > 0, "{stubbed} itself turned todo");
}

/// An exercise with its visible cases.
type Asked = (&'static dyn Examiner, Vec<Case>);

fn visible_cases() -> Vec<Asked> {
    let cases = |examiner: &dyn Examiner| examiner.cases(&mut visible_rng(examiner.name())).cases;
    let all = cases::all();
    all.par_iter()
        .map(|&examiner| (examiner, cases(examiner)))
        .collect()
}

/// What a program says to cases, asked all at once.
fn replies(program: &Program, cases: &[(&dyn Examiner, &Case)]) -> Vec<Said> {
    let questions: Vec<_> = cases
        .iter()
        .map(|(examiner, case)| format!("{} {}", examiner.name(), case.question))
        .collect();
    let replies = ask(program, &questions, LIMITS).expect("the program starts");
    replies.into_iter().map(|reply| reply.said).collect()
}
