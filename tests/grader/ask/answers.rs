//! What counts as an answer, and what as a print.

use crate::ask::{answer, replies, said};
use raybook_grader::ask::Said;
use raybook_grader::converse::Prints;

#[test]
fn an_honest_program_is_heard() {
    let said = said("while read q; do echo thinking; echo \"= $q\"; done", 3);
    assert_eq!(
        said,
        [answer("1"), answer("2"), answer("3")],
        "each question has its answer"
    );
}

#[test]
fn prints_come_with_the_question_they_belong_to() {
    let script = "while read q; do echo \"out $q\"; echo \"err $q\" >&2; echo \"= $q\"; done";
    let replies = replies(script, 2);
    let printed = Prints {
        stdout: "out 2\n".into(),
        stderr: "err 2\n".into(),
    };
    assert_eq!(
        replies[1].printed, printed,
        "both outputs, of the second question only"
    );
}

#[test]
fn garbage_is_an_answer_or_a_print_and_never_a_surprise() {
    assert_eq!(
        said("read q; printf '\\377\\376\\n= 1\\n'", 1),
        [answer("1")],
        "bytes that are not text are printed before"
    );
    assert_eq!(
        said("read q; echo '=1'; echo ' = 2'; echo 'x = 3'", 1),
        [Said::Ended("exit code 0".into())],
        "not at the start of a line, or without its space"
    );
    assert_eq!(
        said("read q; printf '= 1 2'", 1),
        [Said::Ended("exit code 0".into())],
        "half a line is no answer"
    );
    assert_eq!(
        said("read q; printf '= 1\\r\\n'", 1),
        [answer("1")],
        "a Windows line end is a line end"
    );
    assert_eq!(
        said("read q; echo '= nan inf abc'", 1),
        [answer("nan inf abc")],
        "what it is worth, the judge says"
    );
}

#[test]
fn too_many_answers_are_noticed() {
    // Both answers in one write: how long the second may come after the first is a matter of `pairing`.
    let said = said(
        "while read q; do case $q in 2) printf '= 2\\n= again\\n';; *) echo \"= $q\";; esac; done",
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
    let said = said("yes '= 1'", 2);
    assert_eq!(
        said,
        vec![Said::TooMany(2); 2],
        "each question alone gets more than one answer"
    );
}

#[test]
fn todo_panic_and_error_are_understood() {
    let said = said(
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
