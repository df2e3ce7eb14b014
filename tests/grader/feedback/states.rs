//! Feedback where there is no answer, or nothing to mend; descriptions and JSON.

use crate::feedback::{report, right, told};
use raybook_common::snapshot;
use raybook_grader::ask::{Said, Waited};
use raybook_grader::cases;
use raybook_grader::check::State;
use raybook_grader::dress::Dress;
use raybook_grader::{describe, feedback, json, library};
use std::cell::Cell;
use std::time::Duration;

#[test]
fn no_answer() {
    let timed_out = |time| {
        let [time, at_first] = [time, 2.0].map(Duration::from_secs_f32);
        Said::TimedOut(Waited { time, at_first })
    };
    for (name, said) in [
        (
            "panicked",
            Said::Panicked("index out of bounds: the len is 0 but the index is 0".into()),
        ),
        (
            "refused",
            Said::Refused("there is no exercise `ray_at`".into()),
        ),
        (
            "ended",
            Said::Ended(
                "signal 11 (segmentation fault: memory that is not yours, or endless recursion)"
                    .into(),
            ),
        ),
        ("timed_out", timed_out(2.0)),
        ("timed_out_sooner", timed_out(0.125)),
        ("flooded", Said::Flooded(1_048_600)),
        ("too_many", Said::TooMany(2)),
        ("none", Said::Answer("none".into())),
    ] {
        let mut report = report("ray_at", |_, _| said.clone());
        if name == "ended" {
            report.cases[0].reply.printed.stdout = "t is 0point = 1 2 3\nhere= 1 2 3\n".into();
        }
        snapshot(&format!("feedback_{name}"), &told(&report));
    }
}

#[test]
fn not_started_and_waiting() {
    let todo = report("ray_at", |_, _| Said::Todo("ray_at".into()));
    assert_eq!(
        todo.state(),
        State::NotStarted,
        "its own function is not written"
    );
    assert_eq!(
        told(&todo),
        "· not started ray_at\n\n",
        "there is nothing to explain"
    );
    let waits = report("sphere_hit", |_, _| Said::Todo("solve_quadratic".into()));
    assert_eq!(
        waits.state(),
        State::WaitsFor("solve_quadratic".into()),
        "another function is not written"
    );
    assert_eq!(
        told(&waits),
        "… waits       sphere_hit           for solve_quadratic\n\n",
        "and says which"
    );
}

#[test]
fn begun() {
    let asked = Cell::new(0);
    let report = report("ray_at", |examiner, question| {
        asked.set(asked.get() + 1);
        match asked.get() {
            1..=32 => right(examiner, question),
            _ => Said::Todo("ray_at".into()),
        }
    });
    assert_eq!(report.state(), State::Wrong, "some of it is written");
    assert_eq!(
        feedback::line(&report, Dress::default()),
        "wrong       ray_at               32 of 40 cases right, 8 to do"
    );
    let (outcome, why) = report.first_wrong().expect("a case is to do");
    assert_eq!((outcome.case.number, why), (33, "this case is still to do"));
}

#[test]
fn everything_right() {
    let all = report("camera_ray", right);
    assert_eq!(all.state(), State::Right, "the reference is right");
    assert_eq!(
        feedback::line(&all, Dress::default()),
        "right       camera_ray           41 of 41 cases right",
        "in plain text too"
    );
}

#[test]
fn the_description_of_an_exercise() {
    let describe = |name: &str| {
        let examiner = cases::find(name).expect("the exercise exists");
        describe::describe(examiner, library::place(name).as_deref(), true)
    };
    snapshot(
        "feedback_describe",
        &[
            describe("sphere_hit"),
            describe("vertex_normals"),
            describe("box_clip"),
        ]
        .join("\n"),
    );
}

#[test]
fn results_as_json() {
    let mut reports = vec![
        (
            report("ray_at", |_, _| Said::Answer("0 0 0".into())),
            Some("a.png".into()),
        ),
        (report("ray_at", right), None),
    ];
    for (report, _) in &mut reports {
        report.cases.truncate(1);
    }
    snapshot("feedback_json", &format!("{:#}", json::results(&reports)));
}
