//! Feedback on answers that are wrong.

use crate::feedback::{report, right, told};
use raybook_common::snapshot;
use raybook_grader::ask::Said;
use raybook_grader::cases;
use raybook_grader::examine::Examiner;
use raybook_grader::json;
use raybook_grader::picture::ask::{pixel_questions, triples};

#[test]
fn a_known_mistake() {
    let far_root = |examiner: &dyn Examiner, question: &str| {
        examiner.mistaken(0, question).expect("it answers")
    };
    let mut report = report("sphere_hit", |examiner, question| {
        Said::Answer(far_root(examiner, question).into())
    });
    report.cases[0].reply.printed.stdout = "discriminant 1\ndbg: t = 4\n".into();
    let examiner = cases::find("sphere_hit").expect("the exercise exists");
    let pixels: Vec<_> = pixel_questions(examiner)
        .iter()
        .map(|question| Some(far_root(examiner, question)))
        .collect();
    report.pictures = triples(examiner, &pixels);
    snapshot("feedback_known_mistake", &told(&report));
}

#[test]
fn several_pictures() {
    let examiner = cases::find("trace").expect("the exercise exists");
    let mistakes = examiner.mistakes();
    let colourless = mistakes
        .iter()
        .position(|(name, _)| *name == "forgets the colour of mirrors");
    let colourless = colourless.expect("the mistake exists");
    let answer = |question: &str| examiner.mistaken(colourless, question).expect("it answers");
    let mut report = report("trace", |_, question| Said::Answer(answer(question).into()));
    let pixels: Vec<_> = pixel_questions(examiner)
        .iter()
        .map(|question| Some(answer(question)))
        .collect();
    report.pictures = triples(examiner, &pixels);
    snapshot("feedback_several_pictures", &told(&report));
    let json = json::results(&[(report, Some("trace.png".into()))]);
    let passed = |i: usize| json["exercises"][0]["pictures"][i]["passed"].clone();
    assert_eq!(
        (passed(0), passed(2)),
        (true.into(), false.into()),
        "the score is in the JSON too: {json}"
    );
}

/// Each alone explains nothing: they are told in one sentence.
#[test]
fn two_mistakes_in_the_same_answers_are_one_explanation() {
    let report = report("camera_ray", |_, question| {
        let words = question.split_whitespace();
        let q: Vec<f32> = words.map(|word| word.parse().expect("a number")).collect();
        let axis = |first: usize, length: f32| glam::Vec3::from_slice(&q[first..]) * length;
        let ahead = axis(3, q[12]);
        let direction = ahead + axis(6, q[15] * q[13]) + axis(9, q[16] * q[14]);
        let [o, d] = [axis(0, 1.0), direction.normalize()];
        Said::Answer(format!("{} {} {} {} {} {}", o.x, o.y, o.z, d.x, d.y, d.z).into())
    });
    let told = told(&report);
    let explained = told
        .lines()
        .find(|line| line.contains(" look as if your function "));
    let explained = explained.unwrap_or_else(|| panic!("it is explained: {told}"));
    assert!(
        explained.contains("41 of the 41") && explained.contains(", and also "),
        "{told}"
    );
    assert_eq!(told.matches("41 of the 41").count(), 1, "{told}");
    assert_eq!(told.matches("  Hint: ").count(), 2, "{told}");
    let json = json::results(&[(report, None)]);
    let also = &json["exercises"][0]["diagnosis"]["also"][0]["beside"];
    assert_eq!(also, "together", "{json}");
}

#[test]
fn what_a_mistake_does_not_explain_is_counted() {
    let report = report("encode_srgb", |_, question| {
        let value: f32 = question.trim().parse().expect("a number");
        let code = if value > 0.5 {
            (7.3 * value).sin().abs()
        } else {
            value.max(0.0).powf(1.0 / 2.2)
        };
        Said::Answer(code.to_string().into())
    });
    let told = told(&report);
    let left: Vec<_> = told
        .lines()
        .filter(|line| line.starts_with("  This does not explain the other "))
        .collect();
    assert_eq!(left.len(), 1, "{told}");
    assert!(told.contains(" look as if your function "), "{told}");
}

#[test]
fn an_unknown_mistake() {
    let off = |examiner: &dyn Examiner, question: &str| match right(examiner, question) {
        Said::Answer(t) if t.unescaped() != "none" => {
            let t: f32 = t.unescaped().parse().expect("a number");
            Said::Answer((t + 0.25).to_string().into())
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
