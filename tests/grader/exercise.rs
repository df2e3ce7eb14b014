//! `raybook exercise`: what is asked, field by field, for people and as data.

use crate::common::command::raybook;
use raybook_common::project;
use raybook_grader::cases;
use raybook_grader::describe::{describe, schema};
use raybook_grader::examine::visible_rng;
use raybook_grader::leeway::{Leeway, leeways};
use raybook_grader::limits::limits;
use serde_json::Value;

#[test]
fn every_field_has_a_kind_and_a_meaning() {
    /// The fields below, and how many there are.
    fn fields(value: &Value, name: &str) -> usize {
        assert!(value["kind"].is_string(), "{name}: {value}");
        let meaning = value["meaning"].as_str();
        assert!(
            meaning.is_none_or(|meaning| meaning.len() > 5 && meaning.ends_with('.')),
            "{name}: {meaning:?} is a sentence"
        );
        let named = usize::from(meaning.is_some());
        let lists = ["fields", "choices"].map(|key| value[key].as_array());
        let below = lists.into_iter().flatten().flatten();
        let below = below.chain(value.get("of"));
        named + below.map(|value| fields(value, name)).sum::<usize>()
    }
    for examiner in cases::all() {
        let (name, schema) = (examiner.name(), schema(examiner));
        assert!(
            fields(&schema["question"], name) > 0,
            "{name} is given something"
        );
        assert!(fields(&schema["answer"], name) > 0, "{name} has an answer");
        assert!(schema["answer"]["meaning"].is_string(), "{name}");
        assert!(schema["file"].is_string(), "{name} is written somewhere");
        let text = describe(examiner, None, true);
        let mut lines = text.lines();
        let heading = |line: &str| line.contains("kind") && line.ends_with("meaning and unit");
        assert!(
            lines.any(heading) && lines.any(heading),
            "{name}: two tables\n{text}"
        );
    }
}

#[test]
fn a_task_is_short() {
    for examiner in cases::all() {
        let (name, length) = (examiner.name(), examiner.task().chars().count());
        assert!(length <= 300, "the task of {name} has {length} characters");
    }
}

#[test]
fn the_ranges_are_those_of_the_cases() {
    let home = project("");
    let (code, said) = raybook(&home, &["exercise", "sphere_hit"]);
    assert_eq!(code, 0, "{said}");
    for line in [
        "    radius        number            0.125 to 2      The sphere's radius, in metres, above 0.",
        "    within        min max           -9 to 9, inf    The distances that count: min < t < max, in metres.",
        "    t      number or none   -4 to 4096, none   The distance along the ray, in metres; none for a miss.",
    ] {
        assert!(said.contains(line), "{line}\n{said}");
    }
    let (_, said) = raybook(&home, &["exercise", "mesh_hit", "--json"]);
    let said: Value = serde_json::from_str(&said).expect("it is JSON");
    let mesh_hit = &said["exercises"][0];
    let triangles = &mesh_hit["question"]["fields"][2];
    assert_eq!(triangles["name"], "triangles", "{triangles}");
    assert_eq!(triangles["least"], 0.0, "the list may be empty");
    assert_eq!(mesh_hit["answer"]["none"], true, "a ray may miss");
    let within = &mesh_hit["question"]["fields"][1];
    assert_eq!(within["infinite"], true, "an interval may be endless");
}

#[test]
fn limits_are_those_of_the_cases_and_the_judge() {
    for examiner in cases::all() {
        let cases = examiner.cases(&mut visible_rng(examiner.name())).cases;
        let said = limits(examiner, &cases);
        let compared = [
            "may be off by",
            "typically be off by",
            "no other value",
            "not compared one by one",
        ];
        let of_comparing = |line: &String| compared.iter().any(|words| line.contains(words));
        assert!(
            said.iter().any(of_comparing),
            "{} says how exactly it compares: {said:#?}",
            examiner.name()
        );
    }
    let said = |name: &str| {
        let (_, said) = raybook(&project(""), &["exercise", name]);
        said
    };
    for (exercise, line) in [
        ("sphere_hit", "Of length 1 in every question: `direction`."),
        ("sphere_hit", "May be infinite in a question: `within`."),
        (
            "sphere_hit",
            "The right answer is or holds `none` in 27 of 57 cases, such as \"the sphere is behind\".",
        ),
        ("bounds_of", "May be empty in a question: `points`."),
        ("voxels_of_triangle", "The order of `cells` does not count."),
        ("grid_walk", "The order of `visits` counts."),
        ("grid_walk", "`x`: no other value is right"),
        // Other splits may cost as little.
        ("sah_split", "`left`: no other value is right"),
        // Few boxes too many are forgiven, and none too few are believed.
        ("bvh_closest", "`boxes`: may be larger by "),
        (
            "mesh_hit",
            "Ties, where more than one answer is right, are asked: \"two at the same distance\".",
        ),
        (
            "sphere_hit",
            "One right answer to each case is on file; where a text leaves a choice, the judge takes the others, too.",
        ),
        ("bvh_build", "length 1 to 1000"),
        (
            "bvh_build",
            "The tree may cost 25 % more than the reference's",
        ),
        ("random_pattern", "`point`: not compared one by one"),
        (
            "random_pattern",
            "All answers are judged together, too; who is right so far is asked 64 questions for it, and up to 512",
        ),
        (
            "bvh_build",
            "Who is right in all cases is asked large cases, too, 100 elements and 1000 elements: no answer in time is no fault there, but an error is one.",
        ),
        // Its picture has the largest map.
        ("environment_pdf", "1 to 8"),
        (
            "bvh_closest",
            "What lies just at an end of `within` is asked, and does not count: \"just where the interval ends\", \"just where the interval begins\".",
        ),
        (
            "box_clip",
            "Nothing is asked that hangs on whether an end of `within` counts.",
        ),
        (
            "octree_child",
            "Asked just at a threshold, where last digits of the question decide: \"in the middle\", \"on one middle plane\", \"on the middle plane of x\", \"on the middle plane of z\".",
        ),
        (
            "plane_hit",
            "Who is right in all cases is asked 300 further random questions, and 3000 where a class is graded: a fault in 0.1 % of all questions is then met with 95 %.",
        ),
    ] {
        let said = said(exercise);
        assert!(said.contains(line), "{exercise}: {line}\n{said}");
    }
}

#[test]
fn a_length_is_told_in_digits_however_small() {
    let found = cases::find("triangle_normal").expect("an exercise");
    let question = "0 0 0  0.001 0 0  0 0.001 0";
    let verdict = found.judge(question, &["0 0 1".to_owned()], "0 0 0.000001");
    let why = verdict.expect_err("it is not of length 1");
    assert!(why.contains("has length 1.0e-6;"), "{why}");
}

/// A tolerance that is known: `judge::number` takes what is within one part in 2000.
#[test]
fn the_leeway_is_the_judges() {
    let found = cases::find("plane_hit").expect("an exercise");
    let question = found.asked().read_question("0 2 0 0 -1 0 0 inf 0 1 0 0");
    let question = question.expect("a question");
    let golden = (found.asked().call)(&question);
    let [[Leeway::Within(above), Leeway::Within(below)]] =
        leeways(found, &question, &golden, 0)[..]
    else {
        panic!("one number, and it is compared");
    };
    let judged = |error: f64| {
        let mut got = golden.clone();
        *got.last_mut().expect("t") += error;
        found.compare(&question, &golden, &got).is_ok()
    };
    for error in [above, -below] {
        assert!(judged(error), "{error} is right");
        assert!(!judged(2.0 * error), "and twice as much is wrong");
    }
}

#[test]
fn without_a_name_the_exercises_are_listed() {
    let (code, said) = raybook(&project(""), &["exercise"]);
    assert_eq!(code, 0, "{said}");
    assert!(said.lines().count() < 100, "a line each: {said}");
    for examiner in cases::all() {
        assert!(
            said.contains(examiner.name()),
            "{}: {said}",
            examiner.name()
        );
    }
}

#[test]
fn a_reader_is_printed_for_one_exercise() {
    let home = project("");
    let (code, said) = raybook(&home, &["exercise", "3", "--reader", "cpp"]);
    assert!(code == 2 && said.contains("one exercise"), "{said}");
    // Phong is a chapter too.
    let (code, said) = raybook(&home, &["exercise", "phong", "--reader", "python"]);
    assert!(
        code == 0 && said.contains("def phong(q: PhongExercise) -> Rgb:"),
        "{said}"
    );
}
