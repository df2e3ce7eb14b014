//! A student's whole ray tracer in Python, asked like any other program.

#![cfg(unix)]

use raybook_common::project;
use raybook_grader::ask::Asker;
use raybook_grader::cases;
use raybook_grader::check::{State, check};
use raybook_grader::converse::{Limits, Program};
use raybook_grader::examine::visible_rng;
use raybook_grader::hidden::Key;
use raybook_grader::picture::ask::ask_pixels;
use std::path::PathBuf;
use std::process::Command;
use std::time::Duration;

const LIMITS: Limits = Limits::of(Duration::from_secs(60));

/// The program; `None` where there is no Python.
fn program() -> Option<Program> {
    let file = PathBuf::from("python3");
    let there = Command::new(&file).arg("--version").output();
    if !there.is_ok_and(|output| output.status.success()) {
        println!("there is no python3 here: the ray tracer in Python is not asked");
        return None;
    }
    Some(Program {
        file,
        arguments: vec![project("tests/capstone/trace.py").into()],
        folder: PathBuf::new(),
        sandbox: None,
    })
}

#[test]
fn a_ray_tracer_in_python_answers_every_case_rightly() {
    let Some(program) = program() else { return };
    let trace = cases::find("trace").expect("it is an exercise");
    let mut cases = trace.cases(&mut visible_rng("trace")).cases;
    for student in 0..3 {
        let key = Key {
            course: "a secret".into(),
            term: "spring".into(),
            student: format!("student {student}"),
        };
        cases.extend(trace.cases(&mut key.rng("trace")).cases);
    }
    let report = check(&mut Asker::new(&program, LIMITS), trace, cases).expect("python runs");
    assert_eq!(report.state(), State::Right, "{:?}", report.first_wrong());
}

#[test]
fn its_pictures_are_right_in_every_pixel() {
    let Some(program) = program() else { return };
    let trace = cases::find("trace").expect("it is an exercise");
    let (pictures, stopped) =
        ask_pixels(&mut Asker::new(&program, LIMITS), trace).expect("python runs");
    assert_eq!(stopped, None, "it answers all pixels");
    assert_eq!(pictures.len(), 4, "there are four scenes");
    for picture in pictures {
        println!("{} {:?}", picture.name, picture.score);
        assert_eq!(
            picture.score.wrong(),
            0,
            "{}: {:?}",
            picture.name,
            picture.first_bad
        );
        assert!(
            picture.score.undecided < 40 && picture.score.passed(),
            "{}: {:?}",
            picture.name,
            picture.score
        );
    }
}
