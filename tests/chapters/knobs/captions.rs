//! Captions and figures follow the knobs of their topic.

use super::draw;
use raybook_chapters::lesson::find;

#[test]
fn captions_are_true_where_a_topic_ends() {
    for (chapter, arguments, picture, expected) in [
        (
            "ch14_refraction",
            "--index=1",
            "fresnel",
            "nothing is reflected, at any angle",
        ),
        (
            "ch14_refraction",
            "--index=1",
            "beams",
            "nothing is reflected",
        ),
        (
            "ch14_refraction",
            "--index=2.42",
            "beams",
            "index of refraction of 2.42",
        ),
        (
            "ch14_refraction",
            "--index=2.42",
            "beams",
            "nothing goes through beyond 24.4°",
        ),
        (
            "ch19_depth_of_field",
            "--f-number=26.8",
            "picture",
            "too small to show the sides",
        ),
        ("ch19_depth_of_field", "--focus=5", "blur", "focused at 5 m"),
        (
            "ch06_triangle",
            "--look=normal",
            "picture",
            "The geometric normal",
        ),
        (
            "ch10_octree",
            "--depth=5",
            "picture",
            "after at most 5, 4 cuts",
        ),
        (
            "ch17_rendering_equation",
            "--depth=1",
            "picture",
            "straight from the lamp, and the ceiling gets none",
        ),
        (
            "ch17_rendering_equation",
            "--strategy=light",
            "picture",
            "found by directions towards the lamp",
        ),
    ] {
        let lesson = find(chapter).expect("there is this chapter");
        let (_, caption) = draw(lesson, &[arguments.to_owned()], picture);
        assert!(
            caption.contains(expected),
            "{chapter} {arguments}: {caption}"
        );
    }
}

#[test]
fn figures_follow_the_knobs_of_their_topic() {
    for (chapter, argument, picture) in [
        ("ch14_refraction", "--index=2.42", "beams"),
        ("ch14_refraction", "--index=2.42", "fresnel"),
        ("ch19_depth_of_field", "--focus=5", "blur"),
        ("ch10_octree", "--depth=4", "levels"),
        ("ch17_rendering_equation", "--depth=1", "caustic"),
    ] {
        let lesson = find(chapter).expect("there is this chapter");
        let of = |arguments: &[String]| draw(lesson, arguments, picture).0;
        assert!(
            of(&[]) != of(&[argument.to_owned()]),
            "{chapter} {argument} does not change `{picture}`"
        );
    }
}
