//! Described scenes on a line.

use raybook::scene::description::Description;
use raybook::scene::four_scenes::FOUR;
use raybook_workbook::exercises::ch25_capstone::Trace;
use raybook_workbook::row::{self, Row};

/// Ambient light, backdrop, a lamp, and one thing of each shape and of each material.
const SCENE: &str = "0.5 0.5 0.5  1 1 1  0 0 1  1  0 4 0  30 20 10  3  \
    sphere 0 1 0  1  phong 0.5 0.4 0.3  0.2 0.1 0.1  0.3 0.3 0.3  20  \
    plane 0 1 0  0  mirror 0.9 0.8 0.7  triangle 0 0 0  1 0 0  0 1 0  glass 1.5";

#[test]
fn a_scene_is_read_and_written_word_by_word() {
    let scene: Description = row::read(SCENE, "scene").expect("it is a scene");
    assert_eq!(scene.objects.len(), 3, "the count is three");
    assert_eq!(scene.write(), SCENE, "what is read is written again");
    for staged in &FOUR {
        let scene = (staged.scene)();
        let again = row::read(&scene.write(), "scene");
        assert_eq!(again, Ok(scene), "{}: no digit is lost", staged.name);
    }
}

#[test]
fn the_four_scenes_are_short_enough_to_read() {
    for staged in &FOUR {
        let scene = (staged.scene)();
        let words = scene.write().split_whitespace().count();
        println!(
            "{}: {} things, {words} words",
            staged.name,
            scene.objects.len()
        );
        assert!(
            scene.objects.len() <= 12,
            "{}: a dozen things at most",
            staged.name
        );
    }
}

#[test]
fn a_wrong_scene_is_refused_with_the_word_that_is_wrong() {
    for (from, to, complaint) in [
        (
            "sphere",
            "cone",
            "word 18 should be `form`, one of the words sphere, plane, triangle, but is `cone`",
        ),
        (
            "mirror",
            "wood",
            "`matter`, one of the words phong, mirror, glass, but is `wood`",
        ),
        ("glass 1.5", "glass", "word 54, `index`, is missing"),
        ("glass 1.5", "glass 1.5 2", "word 55, `2`, is one too many"),
        ("plane 0 1 0", "plane 0 0 0", "a direction"),
    ] {
        let line = SCENE.replace(from, to);
        let error = row::read::<Description>(&line, "scene").expect_err("it is no scene");
        assert!(
            error.to_string().contains(complaint),
            "{error} should say {complaint}"
        );
    }
}

#[test]
fn the_names_tell_the_kinds_and_each_thing_is_shown_on_a_line() {
    let names = Trace::KIND.names("question").join(" ");
    for part in [
        "depth origin.x",
        "(sphere center.x center.y center.z radius | plane normal.x normal.y normal.z offset | triangle p0.x",
        "exponent | mirror share.r share.g share.b | glass index)",
    ] {
        assert!(names.contains(part), "{names} should contain {part}");
    }
    let scene: Description = row::read(SCENE, "scene").expect("it is a scene");
    let parts = row::parts(Description::KIND, "scene", &row::to_numbers(&scene));
    let things = parts
        .iter()
        .filter(|(name, _)| name.starts_with("objects["));
    assert_eq!(things.count(), 3, "three lines for three things: {parts:?}");
}
