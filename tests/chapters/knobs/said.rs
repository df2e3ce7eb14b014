//! What a chapter's command says: its help, and why it refuses nonsense.

use super::run;

/// A command that cannot be carried out is refused in a sentence with these words.
fn refused(chapter: &str, arguments: &[&str], expected: &str) {
    let (code, said, _) = run(chapter, arguments);
    assert_eq!(code, Some(2), "{chapter} {arguments:?}: {said}");
    assert!(said.contains(expected), "{chapter} {arguments:?}: {said}");
    assert!(
        !said.contains("panicked") && !said.contains("error: error:"),
        "{chapter} {arguments:?}: {said}"
    );
}

#[test]
fn nonsense_is_refused_in_a_sentence() {
    for (chapter, arguments, expected) in [
        (
            "ch12_phong",
            &["--exponent", "0.5"][..],
            "--exponent 0.5: a number from 1 to 1024",
        ),
        (
            "ch12_phong",
            &["--exponent", "NaN"],
            "--exponent NaN: a number from 1 to 1024",
        ),
        (
            "ch12_phong",
            &["--exponent", "many"],
            "--exponent many: a number from 1 to 1024",
        ),
        (
            "ch19_depth_of_field",
            &["--blades", "4.5"],
            "--blades 4.5: a whole number from 3 to 32 blades",
        ),
        (
            "ch04_plane",
            &["--tilt", "-80"],
            "--tilt -80: a number from -60 to 60°",
        ),
        (
            "ch01_rays",
            &["--focal-length", "20", "--field-of-view", "60"],
            "cannot be used with",
        ),
        ("ch07_mesh", &["--mesh", "missing.obj"], "missing.obj"),
        ("ch11_bvh", &["--mesh", "Cargo.toml"], "must end in .obj"),
        ("ch18_environment", &["--map", "missing.hdr"], "missing.hdr"),
        (
            "ch15_shadows",
            &["--offset", "6"],
            "--offset 6: a number from 0 to 5 m",
        ),
        (
            "ch11_bvh",
            &["--leaf", "0"],
            "--leaf 0: a number from 1 to 64 triangles",
        ),
        (
            "ch11_bvh",
            &["--structure", "tree"],
            "[possible values: list, ",
        ),
        (
            "ch14_refraction",
            &["--liquid", "0.9"],
            "--liquid 0.9: a number from 1 to 3",
        ),
        (
            "ch19_depth_of_field",
            &["--aperture", "10", "--f-number", "2"],
            "cannot be used with",
        ),
    ] {
        refused(chapter, arguments, expected);
    }
}

#[test]
fn what_cannot_be_varied_is_refused_in_a_sentence() {
    for (chapter, arguments, expected) in [
        (
            "ch12_phong",
            &["--vary", "exponent=1:8:2"][..],
            "--exponent 1:8:2: a number from 1 to 1024",
        ),
        (
            "ch11_bvh",
            &["--vary", "leaf=1", "--picture", "roof"],
            "there are picture, letters, stages, organisations, builders, growth, levels, heat, speeds",
        ),
        ("ch12_phong", &["--vary", "exponent"], "exponent=1,8,64"),
        (
            "ch12_phong",
            &["--vary", "samples=0,4"],
            "'0' for '--samples",
        ),
        (
            "ch12_phong",
            &["--vary", "expnent=1,2"],
            "has no such knob; it has exponent, incidence, turn, lamp, samples, seed",
        ),
        (
            "ch12_phong",
            &["--vary", "exponent=1,2000"],
            "--exponent 2000: a number from 1 to 1024",
        ),
        (
            "ch03_sphere",
            &["--vary", "radius=0.1,0.2", "--picture", "roof"],
            "there are picture, letters, roots, cancellation",
        ),
        ("ch03_sphere", &["--animate"], "--vary"),
        (
            "ch19_depth_of_field",
            &["--vary", "f-number=2,4", "--vary", "focus=1,2"],
            "vary f-number, and give focus one value with --focus 1",
        ),
        (
            "ch19_depth_of_field",
            &["--vary", "focus=1,2", "--vary", "focus=3"],
            "write all values of focus behind one --vary",
        ),
    ] {
        refused(chapter, arguments, expected);
    }
}

#[test]
fn help_has_groups_units_and_an_example() {
    let (_, said, _) = run("ch19_depth_of_field", &["--help"]);
    for expected in [
        "A lens gathers light",
        "Pictures:",
        "Depth of field:",
        "--f-number <0.7..128>",
        "--focus <0.2..100 m>",
        "[default: 1.4]",
        "ch19_depth_of_field --vary f-number=1.4,2.8",
    ] {
        assert!(said.contains(expected), "{expected}: {said}");
    }
    let place = |what: &str| said.find(what).expect("it is there");
    assert!(
        place("Examples:") < place("Depth of field:")
            && place("Depth of field:") < place("Pictures:"),
        "an example first, then the topic's knobs: {said}"
    );
    let empty = said.lines().filter(|line| line.is_empty()).count();
    assert_eq!(empty, 4, "a line for each option: {said}");
}
