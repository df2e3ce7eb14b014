//! A missing guard is named by what the function dies of, in the words of three languages.

use raybook_grader::ask::{Reply, Said};
use raybook_grader::cases;
use raybook_grader::check::assess;
use raybook_grader::converse::Prints;
use raybook_grader::diagnose::Diagnosis;
use raybook_grader::examine::{Case, visible_rng};

/// What is found if the function panics with a message in some cases, and answers the others by `answer`.
fn found(
    exercise: &str,
    message: &str,
    dies: impl Fn(&Case) -> bool,
    answer: impl Fn(&Case) -> String,
) -> Option<Diagnosis> {
    let examiner = cases::find(exercise).expect("an exercise");
    let cases = examiner.cases(&mut visible_rng(exercise)).cases;
    let reply = |case: &Case| {
        Reply {
        said: if dies(case) {
            Said::Panicked(message.into())
        } else {
            Said::Answer(answer(case).into())
        },
        printed: Prints {
            stderr: "Traceback (most recent call last):\n  File \"my-rays/ch04_plane.py\", line 12, in plane_hit\nError".into(),
            ..Prints::default()
        },
    }
    };
    let replies = cases.iter().map(reply).collect();
    assess(examiner, cases, replies).diagnosis
}

fn rightly(case: &Case) -> String {
    case.answers[0].clone()
}

#[test]
fn a_missing_guard_is_named_by_what_the_function_dies_of() {
    for (exercise, case, message, name) in [
        (
            "plane_hit",
            "parallel to it",
            "ZeroDivisionError: float division by zero",
            "divides by 0",
        ),
        (
            "bounds_of",
            "no points: the empty box, from +infinity to -infinity",
            "index out of bounds: the len is 0 but the index is 0",
            "takes something from a list that is not in it",
        ),
        (
            "grid_walk",
            "beside it, parallel",
            "called `Option::unwrap()` on a `None` value",
            "goes on with an answer that is none",
        ),
        (
            "sphere_hit",
            "past it",
            "ValueError: math domain error",
            "takes a root or an angle of a number that has none",
        ),
        (
            "octree_build",
            "random 1",
            "RecursionError: maximum recursion depth exceeded",
            "calls itself without end",
        ),
        (
            "octree_build",
            "random 1",
            "attempt to subtract with overflow",
            "subtracts more from a whole number than there is",
        ),
        (
            "grid_resolution",
            "a flat square",
            "attempt to add with overflow",
            "makes a whole number of a number that is infinite, NaN, or too large",
        ),
        (
            "plane_hit",
            "parallel to it",
            "AttributeError: 'NoneType' object has no attribute 'x'",
            "goes on with an answer that is none",
        ),
        (
            "plane_hit",
            "parallel to it",
            "AttributeError: 'Ray' object has no attribute 'start'",
            "asks for a member that is not there",
        ),
        (
            "plane_hit",
            "parallel to it",
            "NameError: name 'inf' is not defined",
            "uses a name that means nothing there",
        ),
    ] {
        let found = found(exercise, message, |one| one.name == case, rightly);
        let found = found.unwrap_or_else(|| panic!("{exercise}: nothing is named"));
        assert_eq!(
            (found.name.as_str(), found.certain, found.explained),
            (name, true, 1),
            "{exercise}"
        );
    }
}

#[test]
fn what_the_function_dies_of_stands_beside_what_it_gets_wrong() {
    let examiner = cases::find("plane_hit").expect("an exercise");
    let far = |case: &Case| examiner.mistaken(0, &case.question).expect("an answer");
    let dies = |case: &Case| case.name == "parallel to it";
    let found = found("plane_hit", "ZeroDivisionError", dies, far).expect("a mistake is named");
    assert_eq!(
        found.name,
        examiner.mistakes()[0].0,
        "ZeroDivisionError alone says nothing"
    );
    let message = "ZeroDivisionError: division by zero";
    let found = self::found("plane_hit", message, dies, far).expect("a mistake is named");
    assert_eq!(found.name, examiner.mistakes()[0].0, "it explains more");
    assert_eq!(found.also[0].name, "divides by 0", "it is told too");
}

#[test]
fn an_error_beside_another_mistake_is_told_with_its_case_and_its_line() {
    let examiner = cases::find("plane_hit").expect("an exercise");
    let far = |case: &Case| examiner.mistaken(0, &case.question).expect("an answer");
    for (message, name) in [
        ("ZeroDivisionError: division by zero", "divides by 0"),
        ("what now?", "stops with an error"),
    ] {
        let dies = |case: &Case| case.name == "parallel to it";
        let found = found("plane_hit", message, dies, far).expect("a mistake is named");
        let stopped = &found.also[0];
        assert_eq!(stopped.name, name);
        let cases = examiner.cases(&mut visible_rng("plane_hit")).cases;
        let place = cases.iter().position(dies);
        assert_eq!(stopped.shown, place);
        let number = place.map_or(0, |place| cases[place].number);
        let told = format!("It is case {number}, \"parallel to it\", in ch04_plane.py:12.");
        assert!(stopped.hint.ends_with(&told), "{}", stopped.hint);
    }
}

#[test]
fn a_file_that_cannot_be_loaded_is_no_function_that_stops() {
    for (message, name) in [
        (
            "SyntaxError: invalid syntax (ch04_plane.py, line 12)",
            "is in a file that Python cannot read",
        ),
        (
            "IndentationError: unexpected indent (ch04_plane.py, line 12)",
            "is in a file that Python cannot read",
        ),
        (
            "ModuleNotFoundError: No module named 'ch04_plane'",
            "imports what is not there",
        ),
    ] {
        let found = found("plane_hit", message, |_| true, rightly).expect("it is told");
        assert_eq!((found.name.as_str(), found.certain), (name, true));
    }
}

#[test]
fn an_error_that_no_language_is_known_for_is_told_with_its_case() {
    let dies = |case: &Case| case.name == "parallel to it";
    let found = found("plane_hit", "what now?", dies, rightly).expect("it is told");
    assert_eq!(
        (found.name.as_str(), found.certain),
        ("stops with an error", true)
    );
}

#[test]
fn a_mistake_that_explains_every_answer_that_came_is_told_before_the_error() {
    let turned = |case: &Case| {
        let asked = cases::find("sphere_normal").expect("an exercise").asked();
        let normal = asked.read_answer(&case.answers[0]).expect("an answer");
        let turned: Vec<_> = normal.iter().map(|v| (-v).to_string()).collect();
        turned.join(" ")
    };
    let message = "IndexError: list index out of range";
    let found = found("sphere_normal", message, |case| case.number > 8, turned);
    let found = found.expect("it has a name");
    let error = "takes something from a list that is not in it";
    assert_eq!((found.name == error, &*found.also[0].name), (false, error));
}
