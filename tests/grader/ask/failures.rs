//! Programs that crash, hang, keep silent, flood, or are not there.

use crate::ask::{LIMITS, answer, said, timed_out};
use raybook_grader::ask::{Said, ask};
use raybook_grader::converse::Program;

#[test]
fn a_crash_is_blamed_on_its_question_and_the_others_are_asked() {
    let heard = said(
        "while read q; do if [ $q = 2 ]; then exit 3; fi; echo \"= $q\"; done",
        4,
    );
    assert_eq!(
        heard,
        [
            answer("1"),
            Said::Ended("exit code 3".into()),
            answer("3"),
            answer("4")
        ],
        "only question 2 crashes"
    );
    let heard = said(
        "while read q; do if [ $q = 2 ]; then kill -SEGV $$; fi; echo \"= $q\"; done",
        3,
    );
    assert!(
        matches!(&heard[1], Said::Ended(how) if how.contains("segmentation fault")),
        "the signal has a name: {heard:?}"
    );
    assert_eq!(heard[2], answer("3"), "and the next question is asked");
}

#[test]
fn a_hang_is_stopped_and_the_others_are_asked() {
    let said = said(
        "while read q; do if [ $q = 2 ]; then sleep 600; fi; echo \"= $q\"; done",
        3,
    );
    assert_eq!(
        said,
        [answer("1"), timed_out(LIMITS.time), answer("3")],
        "only question 2 hangs"
    );
}

#[test]
fn a_slow_start_is_borne_and_an_endless_one_is_not() {
    // About a second of the shell's work before it reads anything.
    let work = "i=0; while [ $i -lt 1000000 ]; do i=$((i + 1)); done";
    let heard = said(&format!("{work}; while read q; do echo \"= $q\"; done"), 3);
    assert_eq!(
        heard,
        [answer("1"), answer("2"), answer("3")],
        "it gets going"
    );
    // And one that waits for something, such as a licence server, for longer than an answer may take.
    let wait = 1.5 * LIMITS.time.as_secs_f64();
    let heard = said(
        &format!("sleep {wait}; while read q; do echo \"= $q\"; done"),
        2,
    );
    assert_eq!(heard, [answer("1"), answer("2")], "it wakes up");
    for endless in ["while :; do :; done", "sleep 600"] {
        let heard = said(endless, 1);
        assert_eq!(heard, [timed_out(LIMITS.time)], "{endless}: it never does");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn who_works_and_who_sleeps_is_known() {
    use raybook_grader::inside::usage;
    use std::os::unix::process::CommandExt;
    for (script, works) in [("while :; do :; done", true), ("sleep 600; :", false)] {
        let mut command = std::process::Command::new("/bin/sh");
        let child = command.args(["-c", script]).process_group(0).spawn();
        let mut child = child.expect("the shell can be started");
        // Until it has got going: at once on an idle machine.
        let seen = (0..1000).any(|_| {
            std::thread::sleep(std::time::Duration::from_millis(10));
            let usage = usage(child.id()).expect("it is there");
            usage.at_work == works && (usage.time.as_millis() > 100) == works
        });
        let group = rustix::process::Pid::from_child(&child);
        rustix::process::kill_process_group(group, rustix::process::Signal::KILL).expect("there");
        child.wait().expect("it ends");
        assert!(seen, "{script}");
    }
}

#[test]
fn a_crash_before_the_output_is_flushed_is_blamed_on_the_right_question() {
    // As a C++ program without flush: all answers are held back until the end, which a crash never reaches.
    let script = "held=''; while read q; do if [ $q = 3 ]; then exit 1; fi; held=\"$held= $q\n\"; done; printf '%s' \"$held\"";
    let said = said(script, 4);
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
        said("cat > /dev/null", 2),
        vec![Said::Ended("exit code 0".into()); 2],
        "it reads all and says nothing"
    );
    assert_eq!(
        said("exit 7", 2),
        vec![Said::Ended("exit code 7".into()); 2],
        "it does not even read"
    );
    let closed = said("exec >&- 2>&-; sleep 600", 1);
    assert!(
        matches!(closed[0], Said::Ended(_)),
        "it closes its output and lingers: {closed:?}"
    );
}

#[test]
fn a_program_that_never_answers_is_not_asked_for_ever() {
    let heard = said("exit 7", 40);
    let (asked, rest) = heard.split_at(5);
    assert_eq!(
        asked,
        vec![Said::Ended("exit code 7".into()); 5],
        "five times it is asked"
    );
    assert_eq!(rest, vec![Said::NotAsked(5); 35], "and then no more");

    let heard = said(
        "while read q; do if [ $((q % 5)) = 0 ]; then echo \"= $q\"; else exit 1; fi; done",
        40,
    );
    for (question, said) in (1..=40).zip(&heard) {
        let expected = match question % 5 {
            0 => answer(&question.to_string()),
            _ => Said::Ended("exit code 1".into()),
        };
        assert_eq!(
            *said, expected,
            "now and then it answers: question {question}"
        );
    }
}

#[test]
fn a_flood_is_dammed() {
    let heard = said("yes", 2);
    assert!(
        heard
            .iter()
            .all(|said| matches!(said, Said::Flooded(bytes) if *bytes >= LIMITS.output)),
        "a million lines: {heard:?}"
    );
    let heard = said("head -c 10000000 /dev/zero; echo; read q; echo \"= $q\"", 1);
    assert!(
        matches!(heard[0], Said::Flooded(_)),
        "one endless line: {heard:?}"
    );
}

#[test]
fn no_child_is_left_behind() {
    // A number that no other process on this machine sleeps for.
    let seconds = format!("98{:06}", std::process::id() % 1_000_000);
    said(
        &format!("sleep {seconds} & while read q; do echo \"= $q\"; done"),
        1,
    );
    said(&format!("sleep {seconds} & sleep {seconds}"), 1);
    said(
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
        sandbox: None,
    };
    assert!(
        ask(&program, &["1".into()], LIMITS).is_err(),
        "it cannot be started"
    );
}
