//! A program that does not answer: it is waited for less and less, and asked on as long as it may still be right.

use crate::ask::answer;
use crate::ask::counted::Counted;
use raybook_grader::ask::{Asker, Said, Waited};
use raybook_grader::converse::Limits;
use std::time::{Duration, Instant};

const HANGS: &str =
    "while read q; do case $q in no*) exec sleep 100;; *) echo \"= $q\";; esac; done";

/// The number of questions that were waited for in vain.
fn hung(said: &[Said]) -> usize {
    let hung = |said: &&Said| matches!(said, Said::TimedOut(_));
    said.iter().filter(hung).count()
}

/// What is said after a wait in vain of `time` milliseconds, where an answer has `at_first`.
fn waited([time, at_first]: [u64; 2]) -> Said {
    let [time, at_first] = [time, at_first].map(Duration::from_millis);
    Said::TimedOut(Waited { time, at_first })
}

#[test]
fn who_only_hangs_takes_less_and_less_time() {
    let program = Counted::new("exec sleep 100");
    let limit = Duration::from_millis(160);
    let mut asker = Asker::new(&program.program, Limits::of(limit));
    let six: Vec<String> = ["a", "b", "c", "d", "e", "f"].map(str::to_owned).into();
    let mut exercise = |waits: [u64; 5]| {
        asker.next_exercise();
        let start = Instant::now();
        let replies = asker.ask(&six).expect("the shell can be started");
        let took = start.elapsed();
        let said: Vec<_> = replies.into_iter().map(|reply| reply.said).collect();
        let mut expected = Vec::from(waits.map(|time| waited([time, 160])));
        expected.push(Said::NotAsked(5));
        assert_eq!(said, expected, "five questions of each exercise");
        took
    };
    let first = exercise([160, 80, 40, 20, 10]);
    // Four limits for each start besides, halved likewise.
    assert!(first >= 9 * limit, "{first:?}");
    let later = (0..11).map(|_| exercise([10; 5])).min();
    // With all of the time for each start it would be twice as long as the first. A busy machine makes some of them long, and not all.
    assert!(
        later.is_some_and(|later| later < first),
        "{later:?} after {first:?}"
    );
}

#[test]
fn a_program_that_has_read_its_question_has_started() {
    let program = Counted::new("read q; exec sleep 100");
    let limit = Duration::from_secs(1);
    let questions = vec!["a".to_owned(); 40];
    let takes = || {
        let start = Instant::now();
        let replies = Asker::new(&program.program, Limits::of(limit)).ask(&questions);
        let took = start.elapsed();
        let replies = replies.expect("the shell can be started");
        let said: Vec<_> = replies.into_iter().map(|reply| reply.said).collect();
        assert_eq!(hung(&said), 5, "{said:?}");
        took
    };
    // Who waits for its start too takes nine limits each time. A busy machine may take as long, once.
    let mut took = (0..3).map(|_| takes());
    assert!(took.any(|took| took < 5 * limit) || cfg!(not(target_os = "linux")));
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
fn who_answers_and_is_slow_to_end_is_asked_everything() {
    // An eighth of the limit is waited for its end, in each process of its own.
    let counted = Counted::new("read q; echo \"= $q\"; exec sleep 0.2");
    let questions: Vec<_> = (0..20).map(|i| i.to_string()).collect();
    let mut asker = Asker::at_once(&counted.program, Limits::of(Duration::from_secs(1)));
    let replies = asker.ask(&questions).expect("the shell can be started");
    for (question, reply) in questions.iter().zip(replies) {
        assert_eq!(reply.said, answer(question));
    }
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
            .flat_map(|time| [waited([time, 480]), answer("a")])
            .collect();
        assert_eq!(said, expected, "and what it answers counts");
    }
}
