//! Answer programs of every kind: each ends in a clear reply for each question, within the limits, and leaves nothing behind.

#![cfg(unix)] // the programs are shell scripts

mod answers;
mod counted;
mod failures;
mod hanging;
mod ill_mannered;
mod many;
mod one_process;
mod totals;

use raybook_grader::ask::{Reply, Said, Waited, ask};
use raybook_grader::converse::{Limits, Program};
use std::time::Duration;

const LIMITS: Limits = Limits {
    output: 1 << 16,
    ..Limits::of(Duration::from_secs(1)) // more than a shell takes to start on a busy machine
};

/// What a script says and prints to the questions "1", "2", …
fn replies(script: &str, questions: usize) -> Vec<Reply> {
    let program = Program {
        file: "/bin/sh".into(),
        arguments: vec!["-c".into(), script.into()],
        folder: std::path::PathBuf::new(),
        sandbox: None,
    };
    let questions: Vec<_> = (1..=questions).map(|i| i.to_string()).collect();
    let replies = ask(&program, &questions, LIMITS).expect("the shell can be started");
    assert_eq!(replies.len(), questions.len(), "every question has a reply");
    replies
}

/// What it says alone.
fn said(script: &str, questions: usize) -> Vec<Said> {
    let replies = replies(script, questions);
    replies.into_iter().map(|reply| reply.said).collect()
}

fn answer(text: &str) -> Said {
    Said::Answer(text.into())
}

/// No answer in the time for one, which was not shortened.
fn timed_out(time: Duration) -> Said {
    let at_first = time;
    Said::TimedOut(Waited { time, at_first })
}
