//! `raybook exercise`: what is asked, field by field, for people and as data.

use crate::common::command::raybook;
use raybook_common::project;
use raybook_grader::cases;
use raybook_grader::describe::{describe, schema};
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
        let text = describe(examiner);
        let mut lines = text.lines();
        let heading = |line: &str| line.contains("kind") && line.ends_with("meaning and unit");
        assert!(
            lines.any(heading) && lines.any(heading),
            "{name}: two tables\n{text}"
        );
    }
}

#[test]
fn the_ranges_are_those_of_the_cases() {
    let home = project("");
    let (code, said) = raybook(&home, &["exercise", "sphere_hit"]);
    assert_eq!(code, 0, "{said}");
    for line in [
        "    radius        number            0.125 to 2       The sphere's radius, in metres, above 0.",
        "    within        min max           0 to 5.75, inf   The distances that count: min < t < max, in metres.",
        "    t      number or none   0.000244 to 4096, none   The distance along the ray, in metres; none for a miss.",
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
