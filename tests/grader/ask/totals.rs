//! Limits of what all answers of an exercise, and of a check, take together.

use crate::ask::answer;
use crate::ask::ill_mannered::PATIENT;
use raybook_grader::ask::{Asker, Said};
use raybook_grader::converse::{Limits, Program};
use std::path::PathBuf;
use std::time::Duration;

/// What a script says to a number of questions within total limits.
fn within(script: &str, questions: usize, limits: Limits) -> Vec<Said> {
    let program = Program {
        file: "/bin/sh".into(),
        arguments: vec!["-c".into(), script.into()],
        folder: PathBuf::new(),
        sandbox: None,
    };
    let questions: Vec<_> = (1..=questions).map(|i| i.to_string()).collect();
    let mut asker = Asker::new(&program, limits);
    let replies = asker.ask(&questions).expect("it starts");
    assert_eq!(replies.len(), questions.len(), "each has a reply");
    let mut said: Vec<_> = replies.into_iter().map(|reply| reply.said).collect();
    asker.next_exercise();
    let next = asker.ask(&["last".to_owned()]).expect("it starts");
    said.extend(next.into_iter().map(|reply| reply.said));
    said
}

/// How many were answered, and why the first of the others was not.
fn answered(said: &[Said]) -> (usize, String) {
    let answer = |said: &&Said| matches!(said, Said::Answer(_));
    let count = said.iter().take_while(answer).count();
    let over = |said: &Said| matches!(said, Said::Over(_));
    let last = said.len() - 1;
    assert!(said[count..last].iter().all(over), "and no more is asked");
    let why = said.get(count).and_then(Said::why_none);
    (count, why.unwrap_or_default())
}

/// Whether a limit of 2 s is told, which is longer on a slow machine, and no more is answered than can be in it: each answer takes a
/// twentieth of a second, and a busy machine is forgiven nine tenths of the time.
fn is_limited((count, why): &(usize, String), whole: &str) -> bool {
    let limit = why.split_once(&format!("{whole} together may take "));
    let limit = limit.and_then(|(_, rest)| rest.split_once(" s"));
    let seconds = limit.and_then(|(seconds, _)| seconds.parse::<f64>().ok());
    seconds.is_some_and(|seconds| {
        seconds > 1.999 && *count > 0 && *count as f64 <= (200.0 * seconds).ceil()
    })
}

#[test]
fn time_is_limited_for_an_exercise_and_for_a_check() {
    let script = "while read q; do sleep 0.05; echo \"= $q\"; done";
    let mut limits = PATIENT;
    limits.exercise.time = Duration::from_secs(2);
    let said = within(script, 400, limits);
    let told = answered(&said);
    assert!(is_limited(&told, "an exercise"), "{told:?}");
    let (count, why) = told;
    let help = said[count].help();
    assert!(
        !why.contains("--") && help.contains("--case N"),
        "options are told apart, to who has them: {why}{help}"
    );
    assert_eq!(
        said[400],
        answer("last"),
        "another exercise has its own time"
    );

    limits.exercise.time = Duration::from_secs(60);
    limits.check.time = Duration::from_secs(2);
    let said = within(script, 400, limits);
    let told = answered(&said);
    assert!(is_limited(&told, "a check"), "{told:?}");
    assert!(matches!(said[400], Said::Over(_)), "a check has it once");
}

#[test]
fn bytes_are_limited_for_an_exercise_and_for_a_check() {
    let long = "x=$(head -c 10000 /dev/zero | tr '\\0' 1); while read q; do";
    for script in [
        format!("{long} echo \"= $x\"; done"),
        format!("{long} echo \"$x\"; echo '= 1'; done"),
        format!("{long} echo \"$x\" >&2; echo '= 1'; done"),
    ] {
        let mut limits = PATIENT;
        limits.exercise.bytes = 100_000;
        let said = within(&script, 400, limits);
        let (count, why) = answered(&said);
        assert!(count <= 10, "{script}: {count} of 10 kB each");
        assert!(
            why.contains("may print 100000 bytes for an exercise"),
            "{why}"
        );
        assert!(
            matches!(said[400], Said::Answer(_)),
            "another one has its own"
        );
        limits.check.bytes = 100_000;
        let said = within(&script, 400, limits);
        assert!(matches!(said[400], Said::Over(_)), "a check has it once");
    }
}

#[test]
fn the_usual_limits_bound_what_a_grader_waits_for_and_keeps() {
    let limits = Limits::default();
    assert_eq!(limits.exercise.time, Duration::from_secs(300), "5 minutes");
    assert_eq!(limits.check.time, Duration::from_secs(1800), "half an hour");
    assert!(limits.check.bytes <= 1 << 28, "256 MB");
}
