//! The same question twice: who answers it once only is not right.

use raybook_grader::cases;
use raybook_grader::check::{Mark, Report, State, check_all};
use raybook_grader::converse::{Limits, Program};
use raybook_grader::examine::{Case, visible_rng};
use raybook_grader::picture::ask::Pixels;
use raybook_grader::rare::Depth;
use raybook_workbook::row;
use std::fs;
use std::time::Duration;

/// The report on a script that finds the right answers to the cases of an exercise, in order, in a file that is open as number 3, and
/// with their questions in `table`.
fn checked(exercise: &str, script: &str) -> Report {
    checked_with("", exercise, script)
}

/// The same, with more rows in `table`.
fn checked_with(more: &str, exercise: &str, script: &str) -> Report {
    let examiner = cases::find(exercise).expect("the exercise exists");
    let cases = examiner.cases(&mut visible_rng(exercise)).cases;
    let answers: Vec<_> = cases.iter().map(|case| case.answers[0].as_str()).collect();
    let row = |case: &Case| format!("{exercise} {} = {}\n", case.question, case.answers[0]);
    let table: String = cases.iter().map(row).collect();
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("table"), table + more).expect("it is written");
    fs::write(folder.path().join("answers"), answers.join("\n") + "\n").expect("it is written");
    let program = Program {
        file: "/bin/sh".into(),
        arguments: vec!["-c".into(), format!("exec 3<answers; {script}").into()],
        folder: folder.path().to_owned(),
        sandbox: None,
    };
    let limits = Limits::of(Duration::from_secs(5));
    let reports = check_all(
        &program,
        &[(examiner, cases)],
        limits,
        &|_| Pixels::None,
        Depth::Check,
        &|| {},
    );
    let report = reports
        .expect("the shell can be started")
        .into_iter()
        .next();
    report.expect("one exercise was asked")
}

#[test]
fn what_is_right_only_once_is_wrong() {
    let report = checked(
        "expose",
        "while read q; do read a <&3 || a='0 0 0'; echo \"= $a\"; done",
    );
    assert_eq!(report.state(), State::Wrong);
    let (outcome, why) = report.first_wrong().expect("a case is wrong");
    assert_eq!(outcome.case.number, 1, "the first case is asked again");
    assert!(why.contains("when the same is asked again"), "{why}");
    assert!(
        report.right() >= report.cases.len() - 4,
        "the others stay right"
    );
}

#[test]
fn what_is_wrong_at_first_is_not_asked_again() {
    let report = checked("expose", "while read q; do echo '= 0 0 0'; done");
    let told = |why: &str| !why.contains("asked again");
    let mut wrong = report
        .cases
        .iter()
        .filter_map(|outcome| match &outcome.verdict {
            Mark::Wrong(why) => Some(why.as_str()),
            _ => None,
        });
    assert!(wrong.all(told));
}

/// Answers from the table of visible cases.
const BY_HEART: &str =
    "while read -r q; do a=$(grep -F -m1 -- \"$q = \" table); echo \"= ${a##* = }\"; done";

/// A program that answers the cases of `random_pattern` rightly, and half of the further questions with powers of the right numbers.
fn by_powers(power: f64) -> Report {
    let examiner = cases::find("random_pattern").expect("the exercise exists");
    let cases = examiner.cases(&mut visible_rng(examiner.name())).cases;
    let questions = examiner.further_questions(&cases);
    let row = |question: &Vec<f64>| {
        let question = row::format(examiner.asked().question, question);
        let answer = examiner.answer_line(&question).expect("an answer");
        let (count, numbers) = answer.split_once(' ').expect("points");
        let numbers = numbers.split_whitespace().map(|v| {
            let v: f64 = v.parse().expect("a number");
            format!(" {:.7}", v.powf(power))
        });
        let numbers: String = numbers.collect();
        format!("{} {question} = {count}{numbers}\n", examiner.name())
    };
    let half = &questions[..questions.len() / 2];
    let rows: String = half.iter().map(row).collect();
    // As BY_HEART does, but quickly for long answers.
    let script = "while read -r q; do grep -F -m1 -- \"$q = \" table | sed 's/.* = /= /'; done";
    checked_with(&rows, examiner.name(), script)
}

#[test]
fn a_bias_that_the_cases_hide_shows_in_further_answers() {
    assert_eq!(by_powers(1.0).state(), State::Right);
    let biased = by_powers(1.05);
    let (_, why) = biased.first_wrong().expect("a case is wrong");
    assert!(why.contains("further questions, "), "{why}");
    assert_eq!(biased.right(), 0, "what is in all answers is in each");
    let found = biased.diagnosis.expect("the complaint has a name");
    assert!(found.name.contains("equally often"), "{}", found.name);
}

#[test]
fn who_knows_the_cases_by_heart_does_not_know_what_follows_from_them() {
    let mut known = Vec::new();
    for examiner in cases::all() {
        let name = examiner.name();
        let cases = examiner.cases(&mut visible_rng(name)).cases;
        if examiner.followers(&cases).is_empty() {
            continue;
        }
        known.push(name);
        let report = checked(name, BY_HEART);
        let (outcome, why) = report.first_wrong().unwrap_or_else(|| panic!("{name}"));
        let says = [
            "the case itself is right, but ",
            "with few elements it is right, but ",
        ];
        assert!(says.iter().any(|say| why.contains(say)), "{name}: {why}");
        let follows = [
            ", moved by",
            ", turned so",
            ", with four times",
            " elements",
        ];
        assert!(
            follows.iter().any(|how| outcome.case.name.contains(how)),
            "{name}: {}",
            outcome.case.name
        );
        let asked_random = cases.iter().filter(|case| case.is_random()).count();
        assert!(
            report.right() >= asked_random - 4,
            "{name}: the others stay right"
        );
    }
    assert!(
        known.len() >= 42,
        "exercises whose questions are moved, turned, made finer or enlarged: {known:?}"
    );
}

#[test]
fn who_knows_the_cases_by_heart_does_not_know_further_random_questions() {
    let report = checked("expose", BY_HEART);
    let (outcome, why) = report.first_wrong().expect("a case is wrong");
    assert!(why.contains("of 300 further random questions"), "{why}");
    assert_eq!(outcome.case.number, report.cases.len(), "the last case");
    assert_eq!(report.right(), report.cases.len() - 1);
}
