//! Programs that compute rightly and speak badly: each slip costs its own question and no other.

use crate::ask::{LIMITS, answer};
use raybook_grader::ask::{Asker, Said};
use raybook_grader::cases;
use raybook_grader::check::{Mark, Report, check};
use raybook_grader::converse::{Limits, Program};
use raybook_grader::examine::{Case, visible_rng};
use raybook_grader::picture::ask::pixel_questions;
use std::path::PathBuf;
use std::thread;
use std::time::Duration;

/// Long enough on a machine that does other things too.
pub const PATIENT: Limits = Limits {
    output: LIMITS.output,
    ..Limits::of(Duration::from_secs(4))
};

/// The numbers of the cases at which a program misbehaves.
const ONE: usize = 12;
const NEXT: usize = 13;
const OTHER: usize = 20;

fn ray_at() -> Vec<Case> {
    let examiner = cases::find("ray_at").expect("an exercise");
    examiner.cases(&mut visible_rng("ray_at")).cases
}

/// A shell script that knows the right answers to `ray_at`. Its rule has the right answer as `$a`, the number of the line as `$n`
/// and that of the case as `$case`; `say` prints a line, at once or not before the end.
fn program(rule: &str, flushes: bool) -> Program {
    let answers = ray_at();
    let answers = answers.iter().map(|case| {
        let (number, question, answer) = (case.number, &case.question, &case.answers[0]);
        format!("'ray_at {question}') case={number}; a='= {answer}';;")
    });
    let answers = answers.collect::<Vec<_>>().join("\n");
    let say = if flushes {
        "printf '%s\\n' \"$1\""
    } else {
        "out=\"$out$1\n\""
    };
    let text = format!(
        "say() {{ {say}\n}}\nn=0; out=\nwhile IFS= read -r q; do n=$((n+1))\ncase $q in\n{answers}\nesac\n{rule}\ndone\nprintf '%s' \"$out\"\n"
    );
    Program {
        file: "/bin/sh".into(),
        arguments: vec!["-c".into(), text.into()],
        folder: PathBuf::new(),
        sandbox: None,
    }
}

fn report(program: &Program, limits: Limits) -> Report {
    let examiner = cases::find("ray_at").expect("an exercise");
    check(&mut Asker::new(program, limits), examiner, ray_at()).expect("awk can be started")
}

/// The numbers of the cases that are not right.
fn wrong(report: &Report) -> Vec<usize> {
    let wrong = |outcome: &&raybook_grader::check::Outcome| outcome.verdict != Mark::Right;
    let wrong = report.cases.iter().filter(wrong);
    wrong.map(|outcome| outcome.case.number).collect()
}

/// A rule; the cases that it must cost, and those that it may.
type Manner = (
    &'static str,
    &'static str,
    &'static [usize],
    &'static [usize],
);

const MANNERS: [Manner; 26] = [
    ("is well behaved", "say \"$a\"", &[], &[]),
    (
        "is silent once",
        "[ $case = 12 ] || say \"$a\"",
        &[ONE],
        &[ONE],
    ),
    (
        "answers twice once",
        "say \"$a\"; [ $case = 12 ] && say \"$a\"",
        &[],
        &[ONE],
    ),
    (
        "answers twice, wrongly at first",
        "[ $case = 12 ] && say '= 0 0 0'; say \"$a\"",
        &[ONE],
        &[ONE],
    ),
    (
        "forgets the sign once",
        "[ $case = 12 ] && a=${a#= }; say \"$a\"",
        &[ONE],
        &[ONE],
    ),
    (
        "leaves a line open before an answer",
        "[ $case = 12 ] && a=\"debug$a\"; say \"$a\"",
        &[ONE],
        &[ONE],
    ),
    (
        "leaves a line open that looks like an answer",
        "[ $case = 12 ] && a=\"debug= 2 $a\"; say \"$a\"",
        &[ONE],
        &[ONE],
    ),
    (
        "leaves an answer open",
        "if [ $case = 12 ]; then out=\"$out$a\"; printf '%s' \"$a\"; else say \"$a\"; fi",
        &[ONE],
        &[ONE, NEXT],
    ),
    (
        "is silent, and later answers twice",
        "[ $case = 12 ] || say \"$a\"; [ $case = 20 ] && say \"$a\"",
        &[ONE],
        &[ONE, OTHER],
    ),
    (
        "answers twice, and is silent later",
        "[ $case = 12 ] && say \"$a\"; [ $case = 20 ] || say \"$a\"",
        &[OTHER],
        &[ONE, OTHER],
    ),
    (
        "answers once after the next question",
        "[ \"$held\" ] && say \"$held\"; held=; if [ $case = 12 ]; then held=$a; else say \"$a\"; fi",
        &[],
        &[ONE],
    ),
    (
        "answers once after the next answer",
        "if [ $case = 12 ]; then held=$a; else say \"$a\"; [ \"$held\" ] && say \"$held\"; held=; fi",
        &[],
        &[ONE],
    ),
    (
        "is silent, and later crashes",
        "[ $case = 20 ] && exit 3; [ $case = 12 ] || say \"$a\"",
        &[ONE, OTHER],
        &[ONE, OTHER],
    ),
    (
        "answers twice, and later crashes",
        "[ $case = 20 ] && exit 3; say \"$a\"; [ $case = 12 ] && say \"$a\"",
        &[OTHER],
        &[ONE, OTHER],
    ),
    (
        "is silent, and later hangs",
        "[ $case = 20 ] && sleep 600; [ $case = 12 ] || say \"$a\"",
        &[ONE, OTHER],
        &[ONE, OTHER],
    ),
    (
        "crashes after an answer",
        "say \"$a\"; [ $case = 12 ] && { printf '%s' \"$out\"; exit 3; }",
        &[],
        &[],
    ),
    (
        "gives another question's answer",
        "[ $case = 12 ] && a='= 2.5 0 0'; say \"$a\"",
        &[ONE],
        &[ONE],
    ),
    (
        "begins with a byte-order mark",
        "[ $n = 1 ] && a=$(printf '\\357\\273\\277%s' \"$a\"); say \"$a\"",
        &[],
        &[],
    ),
    (
        "leaves lines open on standard error",
        "printf 'trace= 1 ' >&2; say \"$a\"",
        &[],
        &[],
    ),
    (
        "ends its lines as Windows does",
        "say \"$a$(printf '\\r')\"",
        &[],
        &[],
    ),
    (
        "prints after every answer",
        "say \"$a\"; say next",
        &[],
        &[],
    ),
    (
        "is silent at every fifth line of a process",
        "[ $((n % 5)) = 0 ] || say \"$a\"",
        &[],
        &[],
    ),
    (
        "answers twice at every seventh line of a process",
        "say \"$a\"; [ $((n % 7)) = 0 ] && say \"$a\"",
        &[],
        &[7, 14, 21, 28, 35],
    ),
    (
        "is silent at the fifth line and answers twice at the ninth",
        "[ $n = 5 ] || say \"$a\"; [ $n = 9 ] && say \"$a\"",
        &[],
        &[5, 9],
    ),
    (
        "answers twice at the fifth line and is silent at the thirtieth",
        "[ $n = 30 ] || say \"$a\"; [ $n = 5 ] && say \"$a\"",
        &[],
        &[5, 30],
    ),
    (
        "crashes at every third line",
        "[ $n = 3 ] && exit 1; say \"$a\"",
        &[],
        &[],
    ),
];

/// All of them at once: the grader mostly waits for what is not said.
fn each_slip_costs_its_own_question(flushes: bool) {
    thread::scope(|scope| {
        for manner in &MANNERS {
            scope.spawn(move || a_slip_costs_its_own_question(manner, flushes));
        }
    });
}

fn a_slip_costs_its_own_question((name, rule, must, may): &Manner, flushes: bool) {
    let report = report(&program(rule, flushes), PATIENT);
    let wrong = wrong(&report);
    let how = format!(
        "a program that {name} (flushes: {flushes}): {wrong:?} are wrong, the first {:?}",
        report.first_wrong()
    );
    assert!(must.iter().all(|case| wrong.contains(case)), "{how}");
    assert!(wrong.iter().all(|case| may.contains(case)), "{how}");
    for outcome in &report.cases {
        assert!(
            outcome.verdict == Mark::Right
                || !matches!(outcome.reply.said, Said::NotAsked(_) | Said::Over(_)),
            "{how}, and all are asked"
        );
    }
}

#[test]
fn each_slip_of_a_prompt_program_costs_its_own_question() {
    each_slip_costs_its_own_question(true);
}

#[test]
fn each_slip_of_a_program_that_does_not_flush_costs_its_own_question() {
    each_slip_costs_its_own_question(false);
}

#[test]
fn a_wrong_function_stays_wrong_whatever_is_asked_again() {
    for (name, rule, right) in [
        ("is off by a thousand", "say \"= 1000${a#= }\"", 0),
        ("always says the same", "say '= 1 2 3'", 1),
        (
            "guesses",
            "say \"= 5 6 $(od -An -N4 -tu4 /dev/urandom)\"",
            0,
        ),
    ] {
        for flushes in [true, false] {
            let report = report(&program(rule, flushes), PATIENT);
            assert_eq!(report.right(), right, "a program that {name}");
            let answered = |outcome: &raybook_grader::check::Outcome| {
                matches!(outcome.reply.said, Said::Answer(_))
            };
            assert!(report.cases.iter().all(answered), "a program that {name}");
        }
    }
}

#[test]
fn what_is_written_to_standard_error_stands_beside_its_case() {
    let rule = "if [ $case = 12 ]; then echo here I am >&2; else say \"$a\"; fi";
    let report = report(&program(rule, true), PATIENT);
    let told: Vec<_> = report
        .cases
        .iter()
        .filter(|outcome| !outcome.reply.printed.stderr.unescaped().is_empty())
        .map(|outcome| {
            (
                outcome.case.number,
                outcome.reply.printed.stderr.unescaped(),
            )
        })
        .collect();
    assert_eq!(told, [(ONE, "here I am\n")], "where the question was open");
}

#[test]
fn a_picture_loses_only_the_pixels_at_which_a_program_slips() {
    let examiner = cases::find("camera_ray").expect("an exercise");
    let pixels = pixel_questions(examiner).len();
    // Of 3,456 lines the right answers do not matter here: each has its number.
    for (rule, lost) in [
        ("say \"= $n\"", 0),
        (
            "[ $n = 100 ] || say \"= $n\"; [ $n = 300 ] && say '= again'",
            1,
        ),
        ("[ $n = 300 ] && exit 1; say \"= $n\"", 1),
    ] {
        let text = format!("say() {{ echo \"$1\"; }}; while read -r n; do {rule}; done");
        let program = Program {
            file: "/bin/sh".into(),
            arguments: vec!["-c".into(), text.into()],
            folder: PathBuf::new(),
            sandbox: None,
        };
        let questions: Vec<_> = (1..=pixels).map(|i| i.to_string()).collect();
        let replies = Asker::new(&program, PATIENT)
            .ask(&questions)
            .expect("it starts");
        let wrong = questions.iter().zip(&replies).filter(|(question, reply)| {
            reply.said != answer(question) && !matches!(reply.said, Said::TooMany(_))
        });
        assert_eq!(wrong.count(), lost, "{rule}");
    }
}
