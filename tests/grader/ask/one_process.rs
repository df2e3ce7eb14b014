//! A program that answers is started once, and again only after a misfortune.

use crate::ask::{LIMITS, answer};
use raybook_grader::ask::{Asker, Said};
use raybook_grader::cases;
use raybook_grader::check::check_all;
use raybook_grader::converse::{Limits, Program};
use raybook_grader::examine::{Case, Examiner, visible_rng};
use raybook_grader::picture::Pixels;
use rayon::prelude::*;
use std::fs;
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// Long enough on a machine that does other things too.
const PATIENT: Limits = Limits {
    output: LIMITS.output,
    ..Limits::of(Duration::from_secs(5))
};

/// A script that counts its starts in a file.
struct Counted {
    folder: tempfile::TempDir,
    program: Program,
}

impl Counted {
    fn new(script: &str) -> Self {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let script = format!("echo start >> starts; {script}");
        let program = Program {
            file: "/bin/sh".into(),
            arguments: vec!["-c".into(), script.into()],
            folder: folder.path().to_owned(),
            sandbox: None,
        };
        Self { folder, program }
    }

    fn starts(&self) -> usize {
        let starts = fs::read_to_string(self.folder.path().join("starts"));
        starts.unwrap_or_default().lines().count()
    }
}

fn lists(lists: &[&[&str]]) -> Vec<Vec<String>> {
    let list = |list: &&[&str]| list.iter().map(ToString::to_string).collect();
    lists.iter().map(list).collect()
}

/// What a script says to several lists of questions, and how often it is started.
fn heard(script: &str, questions: &[&[&str]]) -> (Vec<Vec<Said>>, usize) {
    let counted = Counted::new(script);
    let mut asker = Asker::new(&counted.program, PATIENT);
    let mut said = Vec::new();
    for list in lists(questions) {
        let replies = asker.ask(&list).expect("the shell can be started");
        said.push(replies.into_iter().map(|reply| reply.said).collect());
    }
    (said, counted.starts())
}

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
    let reports = check_all(&counted.program, exercises, PATIENT, Pixels::Some, &|| {});
    (reports.expect("the shell can be started"), counted.starts())
}

#[test]
fn all_exercises_are_asked_in_one_process() {
    let (reports, starts) = checked("while read q; do echo '= 0'; done", &all_exercises());
    assert_eq!(starts, 1, "nothing goes wrong");
    assert_eq!(reports.len(), 64, "and all are asked");
    let answered = |said: &Said| *said == answer("0");
    let mut outcomes = reports.iter().flat_map(|report| &report.cases);
    assert!(
        outcomes.all(|outcome| answered(&outcome.reply.said)),
        "each question is answered"
    );
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

const HANGS: &str =
    "while read q; do case $q in no*) exec sleep 100;; *) echo \"= $q\";; esac; done";

/// The number of questions that were waited for in vain.
fn hung(said: &[Said]) -> usize {
    let hung = |said: &&Said| matches!(said, Said::TimedOut(_));
    said.iter().filter(hung).count()
}

#[test]
fn who_only_hangs_takes_less_and_less_time() {
    let program = Counted::new("exec sleep 100");
    let limit = Duration::from_millis(160);
    let mut asker = Asker::new(&program.program, Limits::of(limit));
    let six: Vec<String> = ["a", "b", "c", "d", "e", "f"].map(str::to_owned).into();
    let mut took = Vec::new();
    for _ in 0..12 {
        asker.next_exercise();
        let start = Instant::now();
        let replies = asker.ask(&six).expect("the shell can be started");
        took.push(start.elapsed());
        let said: Vec<_> = replies.into_iter().map(|reply| reply.said).collect();
        assert_eq!(hung(&said), 5, "five questions of each exercise: {said:?}");
        assert_eq!(said[5], Said::NotAsked(5));
    }
    // Five limits for each answer, start included, halved each time; and a sixteenth of it from the fifth on.
    assert!(took[0] >= 9 * limit, "{took:?}");
    took[1..].sort();
    assert!(took[6] < took[0] / 2, "{took:?}");
}

#[test]
fn a_program_that_has_read_its_question_has_started() {
    let program = Counted::new("read q; exec sleep 100");
    let limit = Duration::from_secs(1);
    let questions = vec!["a".to_owned(); 40];
    let start = Instant::now();
    let replies = Asker::new(&program.program, Limits::of(limit)).ask(&questions);
    let took = start.elapsed();
    let replies = replies.expect("the shell can be started");
    let said: Vec<_> = replies.into_iter().map(|reply| reply.said).collect();
    assert_eq!(hung(&said), 5, "{said:?}");
    if cfg!(target_os = "linux") {
        assert!(took < 5 * limit, "without time for its start: {took:?}");
    }
}

#[test]
fn who_hangs_again_and_again_is_not_asked_for_ever() {
    let counted = Counted::new(HANGS);
    let questions: Vec<_> = (0..60)
        .map(|i| {
            if i % 2 == 0 {
                format!("yes {i}")
            } else {
                format!("no {i}")
            }
        })
        .collect();
    let mut asker = Asker::new(&counted.program, Limits::of(Duration::from_millis(400)));
    let replies = asker.ask(&questions).expect("the shell can be started");
    let said: Vec<_> = replies.into_iter().map(|reply| reply.said).collect();
    assert_eq!(hung(&said), 12, "{said:?}");
    assert_eq!(said[59], Said::NotAsked(12), "and then no more");
}

#[test]
fn who_hangs_in_many_exercises_and_then_answers_is_found_right() {
    let counted = Counted::new(HANGS);
    let mut asker = Asker::new(&counted.program, Limits::of(Duration::from_millis(400)));
    let mut ask = |list: &[&str]| -> Vec<Said> {
        asker.next_exercise();
        let list: Vec<_> = list.iter().map(|&question| question.to_owned()).collect();
        let replies = asker.ask(&list).expect("the shell can be started");
        replies.into_iter().map(|reply| reply.said).collect()
    };
    for _ in 0..12 {
        assert_eq!(
            hung(&ask(&["no 1", "no 2", "no 3", "no 4", "no 5", "no 6"])),
            5
        );
    }
    let said = ask(&["no 1", "no 2", "a", "no 3", "b"]);
    assert_eq!([&said[2], &said[4]], [&answer("a"), &answer("b")]);
    assert_eq!(ask(&["c"]), [answer("c")]);
}

#[test]
fn each_wait_in_vain_halves_the_time_for_the_next_answers_of_the_exercise() {
    let counted = Counted::new(HANGS);
    let milliseconds = |time| Said::TimedOut(Duration::from_millis(time));
    let mut asker = Asker::new(&counted.program, Limits::of(Duration::from_millis(480)));
    for _ in 0..2 {
        asker.next_exercise();
        let questions: Vec<_> = (0..8)
            .flat_map(|_| ["no", "a"].map(str::to_owned))
            .collect();
        let replies = asker.ask(&questions).expect("the shell can be started");
        let said: Vec<_> = replies.into_iter().map(|reply| reply.said).collect();
        let expected: Vec<_> = [480, 240, 120, 60, 30, 30, 30, 30]
            .into_iter()
            .flat_map(|time| [milliseconds(time), answer("a")])
            .collect();
        assert_eq!(said, expected, "and what it answers counts");
    }
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

/// What a script says to questions that are many of a kind, after one of another list, and how often it is started.
fn heard_of_many(script: &str, questions: &[&str]) -> (Vec<Said>, usize) {
    let counted = Counted::new(script);
    let mut asker = Asker::new(&counted.program, PATIENT);
    let [first, many] = &lists(&[&["first"], questions])[..] else {
        unreachable!("two lists")
    };
    asker.ask(first).expect("the shell can be started");
    let replies = asker.ask_many(many).expect("the shell can be started");
    let said = replies.into_iter().map(|reply| reply.said).collect();
    (said, counted.starts())
}

#[test]
fn many_questions_are_open_at_a_time() {
    // It answers two questions when it has read both.
    let script =
        "read q; echo '= first'; while read q; do read r; echo \"= $q\"; echo \"= $r\"; done";
    let (said, starts) = heard_of_many(script, &["a", "b", "c", "d"]);
    assert_eq!(said, ["a", "b", "c", "d"].map(answer), "each has its own");
    assert_eq!(starts, 1, "nothing is asked again");
}

#[test]
fn of_many_questions_that_are_not_all_answered_each_is_asked_again() {
    let script = "while read q; do case $q in c) ;; e) exit 3;; *) echo \"= $q\";; esac; done";
    let (said, _) = heard_of_many(script, &["a", "b", "c", "d", "e", "f"]);
    let ended = |how: &str| Said::Ended(how.into());
    let (silent, crash) = (ended("exit code 0"), ended("exit code 3"));
    assert_eq!(
        said,
        [
            answer("a"),
            answer("b"),
            silent,
            answer("d"),
            crash,
            answer("f")
        ],
        "no answer comes to another question than its own"
    );
}

#[test]
fn of_many_questions_one_with_two_answers_is_found() {
    let script = "while read q; do echo \"= $q\"; if [ $q = c ]; then echo '= again'; fi; done";
    let (said, _) = heard_of_many(script, &["a", "b", "c", "d", "e"]);
    let (a, b, d, e) = (answer("a"), answer("b"), answer("d"), answer("e"));
    assert_eq!(said, [a, b, Said::TooMany(2), d, e], "and only this one");
}
