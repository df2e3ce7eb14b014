//! Many questions of a kind, several of them open at a time.

use crate::ask::answer;
use crate::ask::counted::{Counted, PATIENT, lists};
use raybook_grader::ask::{Asker, Said};

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
