//! Answer programs of every kind: each ends in a clear reply for each question, within the limits, and leaves nothing behind.

#![cfg(unix)] // the programs are shell scripts

use raybook::grade::ask::{Said, ask};
use raybook::grade::converse::{Limits, Program};
use std::time::Duration;

const LIMITS: Limits = Limits {
    time: Duration::from_millis(400),
    output: 1 << 16,
};

/// What a script says to so many questions "1", "2", …
fn replies(script: &str, questions: usize) -> Vec<Said> {
    let program = Program {
        file: "/bin/sh".into(),
        arguments: vec!["-c".into(), script.into()],
        folder: std::path::PathBuf::new(),
    };
    let questions: Vec<_> = (1..=questions).map(|i| i.to_string()).collect();
    let replies = ask(&program, &questions, LIMITS).expect("the shell can be started");
    assert_eq!(replies.len(), questions.len(), "every question has a reply");
    replies.into_iter().map(|reply| reply.said).collect()
}

fn answer(text: &str) -> Said {
    Said::Answer(text.into())
}

#[test]
fn an_honest_program_is_heard() {
    let said = replies("while read q; do echo thinking; echo \"= $q\"; done", 3);
    assert_eq!(
        said,
        [answer("1"), answer("2"), answer("3")],
        "each question has its answer"
    );
}

#[test]
fn prints_come_with_the_question_they_belong_to() {
    let program = Program {
        file: "/bin/sh".into(),
        arguments: vec![
            "-c".into(),
            "while read q; do echo \"out $q\"; echo \"err $q\" >&2; echo \"= $q\"; done".into(),
        ],
        folder: std::path::PathBuf::new(),
    };
    let replies =
        ask(&program, &["1".into(), "2".into()], LIMITS).expect("the shell can be started");
    assert_eq!(
        replies[1].printed, "out 2\nerr 2\n",
        "both outputs, in order, of the second question only"
    );
}

#[test]
fn a_crash_is_blamed_on_its_question_and_the_others_are_asked() {
    let said = replies(
        "while read q; do if [ $q = 2 ]; then exit 3; fi; echo \"= $q\"; done",
        4,
    );
    assert_eq!(
        said,
        [
            answer("1"),
            Said::Ended("exit code 3".into()),
            answer("3"),
            answer("4")
        ],
        "only question 2 crashes"
    );
    let said = replies(
        "while read q; do if [ $q = 2 ]; then kill -SEGV $$; fi; echo \"= $q\"; done",
        3,
    );
    assert!(
        matches!(&said[1], Said::Ended(how) if how.contains("segmentation fault")),
        "the signal has a name: {said:?}"
    );
    assert_eq!(said[2], answer("3"), "and the next question is asked");
}

#[test]
fn a_hang_is_stopped_and_the_others_are_asked() {
    let said = replies(
        "while read q; do if [ $q = 2 ]; then sleep 600; fi; echo \"= $q\"; done",
        3,
    );
    assert_eq!(
        said,
        [answer("1"), Said::TimedOut(LIMITS.time), answer("3")],
        "only question 2 hangs"
    );
}

#[test]
fn a_crash_before_the_output_is_flushed_is_blamed_on_the_right_question() {
    // As a C++ program without flush: all answers are held back until the end, which a crash never reaches.
    let script = "held=''; while read q; do if [ $q = 3 ]; then exit 1; fi; held=\"$held= $q\n\"; done; printf '%s' \"$held\"";
    let said = replies(script, 4);
    assert_eq!(
        said,
        [
            answer("1"),
            answer("2"),
            Said::Ended("exit code 1".into()),
            answer("4")
        ],
        "question 3 crashes"
    );
}

#[test]
fn silence_ends_in_words() {
    assert_eq!(
        replies("cat > /dev/null", 2),
        vec![Said::Ended("exit code 0".into()); 2],
        "it reads all and says nothing"
    );
    assert_eq!(
        replies("exit 7", 2),
        vec![Said::Ended("exit code 7".into()); 2],
        "it does not even read"
    );
    let closed = replies("exec >&- 2>&-; sleep 600", 1);
    assert!(
        matches!(closed[0], Said::Ended(_)),
        "it closes its output and lingers: {closed:?}"
    );
}

#[test]
fn garbage_is_an_answer_or_a_print_and_never_a_surprise() {
    assert_eq!(
        replies("read q; printf '\\377\\376\\n= 1\\n'", 1),
        [answer("1")],
        "bytes that are not text are printed before"
    );
    assert_eq!(
        replies("read q; echo '=1'; echo ' = 2'; echo 'x = 3'", 1),
        [Said::Ended("exit code 0".into())],
        "not at the start of a line, or without its space"
    );
    assert_eq!(
        replies("read q; printf '= 1 2'", 1),
        [Said::Ended("exit code 0".into())],
        "half a line is no answer"
    );
    assert_eq!(
        replies("read q; printf '= 1\\r\\n'", 1),
        [answer("1")],
        "a Windows line end is a line end"
    );
    assert_eq!(
        replies("read q; echo '= nan inf abc'", 1),
        [answer("nan inf abc")],
        "what it is worth, the judge says"
    );
}

#[test]
fn a_flood_is_dammed() {
    let said = replies("yes", 2);
    assert!(
        said.iter()
            .all(|said| matches!(said, Said::Flooded(bytes) if *bytes >= LIMITS.output)),
        "a million lines: {said:?}"
    );
    let said = replies("head -c 10000000 /dev/zero; echo; read q; echo \"= $q\"", 1);
    assert!(
        matches!(said[0], Said::Flooded(_)),
        "one endless line: {said:?}"
    );
}

#[test]
fn too_many_answers_are_noticed() {
    let said = replies(
        "while read q; do echo \"= $q\"; if [ $q = 2 ]; then echo '= again'; fi; done",
        3,
    );
    assert_eq!(
        said,
        [answer("1"), Said::TooMany(2), answer("3")],
        "question 2 is answered twice"
    );
}

#[test]
fn endless_answers_are_stopped() {
    let said = replies("yes '= 1'", 2);
    assert_eq!(
        said,
        vec![Said::TooMany(2); 2],
        "each question alone gets more than one answer"
    );
}

#[test]
fn todo_panic_and_error_are_understood() {
    let said = replies(
        "read q; echo '= todo sphere_hit'; read q; echo '= panic index out of range'; read q; echo '= error no'",
        3,
    );
    let expected = [
        Said::Todo("sphere_hit".into()),
        Said::Panicked("index out of range".into()),
        Said::Refused("no".into()),
    ];
    assert_eq!(said, expected, "the three words of the protocol");
}

#[test]
fn no_child_is_left_behind() {
    // A number that no other process on this machine sleeps for.
    let seconds = format!("98{:06}", std::process::id() % 1_000_000);
    replies(
        &format!("sleep {seconds} & while read q; do echo \"= $q\"; done"),
        1,
    );
    replies(&format!("sleep {seconds} & sleep {seconds}"), 1);
    replies(
        &format!("setsid sleep {seconds} & while read q; do echo \"= $q\"; done"),
        1,
    );
    let alive = std::fs::read_dir("/proc")
        .into_iter()
        .flatten()
        .flatten()
        .filter(|entry| {
            let command = std::fs::read(entry.path().join("cmdline")).unwrap_or_default();
            String::from_utf8_lossy(&command).contains(&seconds)
        });
    assert_eq!(alive.count(), 0, "the programs' children are gone");
}

#[test]
fn a_program_that_is_not_there_is_an_error() {
    let program = Program {
        file: "/no/such/program".into(),
        arguments: Vec::new(),
        folder: std::path::PathBuf::new(),
    };
    assert!(
        ask(&program, &["1".into()], LIMITS).is_err(),
        "it cannot be started"
    );
}
