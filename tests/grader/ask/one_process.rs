//! A program that answers is started once for each processor at most, and again only after a misfortune.

use crate::ask::answer;
use crate::ask::counted::{Counted, PATIENT, heard, lists};
use raybook_grader::ask::{Asker, Said};
use raybook_grader::cases;
use raybook_grader::check::{check_all, check_each};
use raybook_grader::converse::Program;
use raybook_grader::examine::{Case, Examiner, visible_rng};
use raybook_grader::picture::ask::Pixels;
use raybook_grader::rare::Depth;
use rayon::prelude::*;
use std::fs;
use std::path::PathBuf;

fn all_exercises() -> Vec<(&'static dyn Examiner, Vec<Case>)> {
    let cases = |examiner: &dyn Examiner| examiner.cases(&mut visible_rng(examiner.name())).cases;
    let all = cases::all();
    all.par_iter()
        .map(|&examiner| (examiner, cases(examiner)))
        .collect()
}

/// The reports of exercises on a script, and how often it is started.
fn checked(
    script: &str,
    exercises: &[(&'static dyn Examiner, Vec<Case>)],
) -> (Vec<raybook_grader::check::Report>, usize) {
    let counted = Counted::new(script);
    let (mut reports, pixels) = (Vec::new(), |_: &dyn Examiner| Pixels::Some);
    let mut each = |report| {
        reports.push(report);
        true
    };
    check_each(
        &counted.program,
        exercises,
        PATIENT,
        &pixels,
        Depth::Check,
        &mut each,
    )
    .expect("the shell can be started");
    (reports, counted.starts())
}

#[test]
fn exercises_one_after_the_other_are_asked_in_one_process() {
    let all = all_exercises();
    let (reports, starts) = checked("while read q; do echo '= 0'; done", &all);
    assert_eq!(starts, 1, "nothing goes wrong");
    assert_eq!(reports.len(), all.len(), "and all are asked");
    let answered = |said: &Said| *said == answer("0");
    let mut outcomes = reports.iter().flat_map(|report| &report.cases);
    assert!(
        outcomes.all(|outcome| answered(&outcome.reply.said)),
        "each question is answered"
    );
}

#[test]
fn many_exercises_are_asked_side_by_side_and_told_in_their_order() {
    let all = all_exercises();
    let counted = Counted::new("while read q; do echo '= 0'; done");
    let pixels = |_: &dyn Examiner| Pixels::Some;
    let reports = check_all(
        &counted.program,
        &all,
        PATIENT,
        &pixels,
        Depth::Check,
        &|| {},
    );
    let processes = rayon::current_num_threads().min(all.len() / 8);
    assert_eq!(counted.starts(), processes, "each is started once");
    let names: Vec<_> = all.iter().map(|(examiner, _)| examiner.name()).collect();
    let reports = reports.expect("the shell can be started");
    let told: Vec<_> = reports.iter().map(|report| report.exercise).collect();
    assert_eq!(told, names);
}

#[test]
fn other_answers_each_time_are_not_asked_in_processes_of_their_own() {
    let mut exercises = all_exercises();
    exercises.retain(|(examiner, _)| examiner.name() == "ray_at");
    let script = "n=0; while read q; do n=$((n + 1)); echo \"= $n 0 0\"; done";
    let (reports, starts) = checked(script, &exercises);
    assert!(
        reports[0].right() < 2,
        "it says the numbers of the questions"
    );
    assert_eq!(
        starts, 1,
        "what it said first is said again to no question: nothing has moved"
    );
}

#[test]
fn a_crash_costs_two_more_processes() {
    let script = "while read q; do case $q in b|e) exit 3;; esac; echo \"= $q\"; done";
    let (said, starts) = heard(script, &[&["a", "b", "c"], &["d", "e", "f"], &["g"]]);
    let crash = || Said::Ended("exit code 3".into());
    assert_eq!(
        said,
        [
            vec![answer("a"), crash(), answer("c")],
            vec![answer("d"), crash(), answer("f")],
            vec![answer("g")]
        ],
        "the right questions are blamed"
    );
    assert_eq!(
        starts, 5,
        "one, and for each crash one that is asked only this, and one for the rest"
    );
}

#[test]
fn who_dies_of_the_last_question_is_not_blamed_for_the_next_exercise() {
    let script = "while read q; do echo \"= $q\"; if [ $q = b ]; then sleep 0.1; exit 3; fi; done";
    let (said, starts) = heard(script, &[&["a", "b"], &["c", "d"]]);
    assert_eq!(
        said,
        [
            vec![answer("a"), answer("b")],
            vec![answer("c"), answer("d")]
        ],
        "everything was answered"
    );
    assert_eq!(
        starts, 3,
        "and the second exercise goes to a new process, after its first question alone"
    );
}

#[test]
fn what_it_does_not_know_is_skipped_and_the_rest_is_asked() {
    let script = "while read q; do case $q in no*) ;; *) echo \"= $q\";; esac; done";
    let unknown = ["no 1", "no 2", "no 3", "no 4", "no 5", "no 6", "no 7"];
    let (said, _) = heard(script, &[&["a", "b"], &unknown, &["c", "d"]]);
    assert_eq!(said[0], [answer("a"), answer("b")], "what it knows");
    assert_eq!(
        said[1][..5],
        vec![Said::Ended("exit code 0".into()); 5],
        "silence"
    );
    assert_eq!(said[1][5..], vec![Said::NotAsked(5); 2], "five times");
    assert_eq!(said[2], [answer("c"), answer("d")], "and what it knows");
}

#[test]
fn a_question_without_an_answer_does_not_shift_the_others() {
    let script = "while read q; do if [ $q != c ]; then echo \"= $q\"; fi; done";
    let (said, _) = heard(script, &[&["a", "b", "c", "d"], &["e"]]);
    let silent = Said::Ended("exit code 0".into());
    assert_eq!(
        said,
        [
            vec![answer("a"), answer("b"), silent, answer("d")],
            vec![answer("e")]
        ],
        "only c has none"
    );
}

#[test]
fn who_holds_the_answers_back_is_started_for_each_list() {
    let script = "held=''; while read q; do held=\"$held= $q\n\"; done; printf '%s' \"$held\"";
    let (said, starts) = heard(script, &[&["a", "b"], &["c", "d"], &["e", "f"]]);
    assert_eq!(said[1], [answer("c"), answer("d")], "and is understood");
    assert_eq!(starts, 4, "once more, to find that out");
}

#[test]
fn an_answer_after_all_questions_belongs_to_none() {
    let script = "while read q; do echo \"= $q\"; done; echo '= bye'";
    let (said, starts) = heard(script, &[&["a", "b"], &["c"]]);
    assert_eq!(
        said,
        [vec![answer("a"), answer("b")], vec![answer("c")]],
        "each question had its answer before"
    );
    assert_eq!(starts, 1, "and nothing went wrong");
}

#[test]
fn python_need_not_flush() {
    let python = PathBuf::from("python3");
    let there = std::process::Command::new(&python)
        .arg("--version")
        .output();
    if !there.is_ok_and(|output| output.status.success()) {
        println!("there is no python3 here: it is not asked");
        return;
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    let text = "import sys\nopen('starts', 'a').write('start\\n')\nfor line in sys.stdin:\n    print('=', line.strip())\n";
    let program = Program {
        file: python,
        arguments: vec!["-c".into(), text.into()],
        folder: folder.path().to_owned(),
        sandbox: None,
    };
    let mut asker = Asker::new(&program, PATIENT);
    for list in lists(&[&["a", "b"], &["c", "d"]]) {
        let replies = asker.ask(&list).expect("python starts");
        let said: Vec<_> = replies.into_iter().map(|reply| reply.said).collect();
        assert_eq!(said, [answer(&list[0]), answer(&list[1])], "as they come");
    }
    let starts = fs::read_to_string(folder.path().join("starts")).expect("it was started");
    assert_eq!(starts.lines().count(), 1, "in one process");
}
