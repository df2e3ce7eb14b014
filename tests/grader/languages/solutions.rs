//! Complete solutions in Python and C++, by other methods than the library's where there are any: all are right.

use super::{new, succeeds, there_is};
use crate::shrink::smallest_questions;
use raybook_grader::ask::Asker;
use raybook_grader::cases;
use raybook_grader::check::{State, check, check_all};
use raybook_grader::converse::Limits;
use raybook_grader::examine::{Case, Examiner, visible_rng};
use raybook_grader::hidden::Key;
use raybook_grader::language::Language;
use raybook_grader::picture::ask::Pixels;
use raybook_grader::rare::Depth;
use raybook_grader::starter::{place, reference, reference_file};
use raybook_grader::student;
use raybook_workbook::curriculum::CHAPTERS;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

/// A machine that is busy with other tests is slow.
const LIMITS: Limits = Limits::of(Duration::from_secs(120));

/// Number of students whose hidden cases are asked besides the visible ones.
const KEYS: usize = 3;

/// Number of exercises that are solved in each language at least. A new one can come before its solutions.
const SOLVED: usize = 64;

/// A starter into which the solutions of all chapters are laid.
fn solved(home: &Path, language: Language) -> PathBuf {
    let folder = new(home, language.name(), language);
    for chapter in CHAPTERS {
        let file = place(language, chapter.exercises()[0].name).expect("the starter has it");
        let solution = reference_file(language, &file).expect("there is a solution");
        fs::write(folder.join(file), solution).expect("it can be written");
    }
    folder
}

fn cases_of(examiner: &dyn Examiner) -> Vec<Case> {
    let name = examiner.name();
    let mut cases = examiner.cases(&mut visible_rng(name)).cases;
    for student in 0..KEYS {
        let key = Key {
            course: "a third course's secret".into(),
            term: "autumn".into(),
            student: format!("student {student}"),
        };
        cases.extend(examiner.cases(&mut key.rng(name)).cases);
    }
    cases
}

/// All exercises that are solved are right, on visible and on hidden cases.
fn has_full_marks(folder: &Path, language: Language) {
    let program = student::build(folder).expect("it is built");
    let all = cases::all();
    let exercises: Vec<_> = all.into_iter().map(|e| (e, cases_of(e))).collect();
    let reports = check_all(
        &program,
        &exercises,
        LIMITS,
        &|_| Pixels::Some,
        Depth::Check,
        &|| (),
    );
    let mut right = 0;
    for report in reports.expect("the program runs") {
        let is_solved = reference(language, report.exercise).is_some();
        assert_eq!(
            report.state(),
            if is_solved {
                State::Right
            } else {
                State::NotStarted
            },
            "{}: {:?}",
            report.exercise,
            report.first_wrong()
        );
        right += usize::from(is_solved);
    }
    assert!(right >= SOLVED, "{right} exercises are solved");
}

#[test]
fn the_solutions_in_python_are_right() {
    if !there_is("python3") {
        return;
    }
    let home = tempfile::tempdir().expect("a temporary folder");
    let folder = solved(home.path(), Language::Python);
    if there_is("mypy") {
        succeeds(Command::new("mypy").arg(".").current_dir(&folder));
    }
    has_full_marks(&folder, Language::Python);
}

/// What is shown to a student as the smallest wrong question is one that a right program answers.
#[test]
fn the_solutions_are_right_on_the_smallest_questions_too() {
    if !there_is("python3") {
        return;
    }
    let home = tempfile::tempdir().expect("a temporary folder");
    let program = student::build(&solved(home.path(), Language::Python)).expect("it is built");
    let mut wrong = Vec::new();
    for (examiner, outcomes) in smallest_questions() {
        if reference(Language::Python, examiner.name()).is_none() {
            continue;
        }
        let cases = outcomes.into_iter().map(|outcome| outcome.case).collect();
        let report = check(&mut Asker::new(&program, LIMITS), examiner, cases);
        let report = report.expect("the program runs");
        wrong.extend(report.first_wrong().map(|(outcome, why)| {
            let (name, question) = (examiner.name(), &outcome.case.question);
            format!("{name} {question}: {:?}: {why}", outcome.reply.said)
        }));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_solutions_in_cpp_are_right() {
    if !there_is("make") || !there_is("g++") {
        return;
    }
    let home = tempfile::tempdir().expect("a temporary folder");
    let folder = solved(home.path(), Language::Cpp);
    let make = |options: &[&str]| {
        let mut make = Command::new("make");
        make.args(["-s", "-j2"]).args(options).current_dir(&folder);
        succeeds(&mut make)
    };
    if there_is("clang++") {
        assert_eq!(
            make(&["CXX=clang++", "CXXFLAGS=-Werror -fsyntax-only", "objects"]),
            ""
        );
        make(&["clean"]);
    }
    assert_eq!(make(&["CXXFLAGS=-O2 -Werror"]), "", "not a word");
    has_full_marks(&folder, Language::Cpp);
}
