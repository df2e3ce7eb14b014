//! What a student reads, for every kind of reply. The snapshots are in `golden/snapshots/feedback_*`: read them as one who is tired.

mod common;

use common::snapshot;
use raybook::grade::ask::{Reply, Said};
use raybook::grade::cases;
use raybook::grade::check::{Report, State, assess};
use raybook::grade::dress::Dress;
use raybook::grade::examine::{Examiner, visible_rng};
use raybook::grade::feedback;
use raybook::grade::json;
use raybook::grade::picture::{pixel_questions, triple};
use std::path::Path;
use std::time::Duration;

const DRESS: Dress = Dress {
    colour: false,
    symbols: true,
};

/// The report on a program that replies so.
fn report(exercise: &str, reply: impl Fn(&dyn Examiner, &str) -> Said) -> Report {
    let examiner = cases::find(exercise).expect("the exercise exists");
    let cases = examiner.cases(&mut visible_rng(exercise)).cases;
    let replies = cases.iter().map(|case| Reply {
        said: reply(examiner, &case.question),
        printed: String::new(),
    });
    let replies = replies.collect();
    assess(examiner, cases, replies)
}

/// What a student with this report reads.
fn told(report: &Report) -> String {
    let examiner = cases::find(report.exercise).expect("the exercise exists");
    let picture = report
        .pictures
        .is_some()
        .then_some(Path::new(".raybook/picture.png"));
    format!(
        "{}\n\n{}",
        feedback::line(report, DRESS),
        feedback::explain(
            report,
            examiner,
            picture,
            &format!("raybook check {}", report.exercise),
            DRESS
        )
    )
}

fn right(examiner: &dyn Examiner, question: &str) -> Said {
    Said::Answer(examiner.answer_line(question).expect("it is a question"))
}

#[test]
fn a_known_mistake() {
    let far_root = |examiner: &dyn Examiner, question: &str| {
        examiner.mistaken(0, question).expect("it answers")
    };
    let mut report = report("sphere_hit", |examiner, question| {
        Said::Answer(far_root(examiner, question))
    });
    report.cases[0].reply.printed = "discriminant 1\ndbg: t = 4\n".into();
    let examiner = cases::find("sphere_hit").expect("the exercise exists");
    let pixels: Vec<_> = pixel_questions(examiner)
        .iter()
        .map(|question| Some(far_root(examiner, question)))
        .collect();
    report.pictures = triple(examiner, &pixels);
    snapshot("feedback_known_mistake", &told(&report));
}

#[test]
fn an_unknown_mistake() {
    let off = |examiner: &dyn Examiner, question: &str| match right(examiner, question) {
        Said::Answer(t) if t != "none" => {
            Said::Answer((t.parse::<f32>().expect("a number") + 0.25).to_string())
        }
        said => said,
    };
    snapshot(
        "feedback_unknown_mistake",
        &told(&report("sphere_hit", off)),
    );
}

#[test]
fn a_hit_for_a_miss_and_a_miss_for_a_hit() {
    snapshot(
        "feedback_never_hits",
        &told(&report("triangle_hit", |_, _| Said::Answer("none".into()))),
    );
    snapshot(
        "feedback_always_hits",
        &told(&report("plane_hit", |_, _| Said::Answer("1".into()))),
    );
}

#[test]
fn numbers_that_are_none() {
    snapshot(
        "feedback_nan",
        &told(&report("ray_at", |_, _| Said::Answer("nan 0 0".into()))),
    );
    snapshot(
        "feedback_not_unit",
        &told(&report("sphere_normal", |_, _| {
            Said::Answer("0 2 0".into())
        })),
    );
    snapshot(
        "feedback_infinite",
        &told(&report("encode_srgb", |_, _| Said::Answer("inf".into()))),
    );
}

#[test]
fn answers_that_cannot_be_read() {
    snapshot(
        "feedback_too_short",
        &told(&report("ray_at", |_, _| Said::Answer("1 2".into()))),
    );
    snapshot(
        "feedback_too_long",
        &told(&report("ray_at", |_, _| Said::Answer("1 2 3 4".into()))),
    );
    snapshot(
        "feedback_not_a_number",
        &told(&report("ray_at", |_, _| Said::Answer("1 two 3".into()))),
    );
    snapshot(
        "feedback_wrong_count",
        &told(&report("vertex_normals", |_, _| {
            Said::Answer("1  0 1 0".into())
        })),
    );
}

#[test]
fn no_answer() {
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
        ("timed_out", Said::TimedOut(Duration::from_secs(2))),
        ("flooded", Said::Flooded(1_048_600)),
        ("too_many", Said::TooMany(2)),
    ] {
        let mut report = report("ray_at", |_, _| said.clone());
        if name == "ended" {
            report.cases[0].reply.printed = "t is 0point = 1 2 3\nhere= 1 2 3\n".into();
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
        raybook::grade::describe::describe(cases::find(name).expect("the exercise exists"))
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
