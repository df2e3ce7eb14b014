//! Every chapter has knobs, each changes a picture, and nonsense is refused in a sentence.

use assert_cmd::Command;
use raybook::image::{Image, file, rgb::Rgb};
use raybook_chapters::LESSONS;
use raybook_chapters::kit::knobs::{self, Kind, Knob};
use raybook_chapters::kit::options::Options;
use raybook_chapters::kit::stage::{Stage, progress_bar};
use raybook_chapters::lesson::{Lesson, find};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// Values where those of the examples take long, change nothing, or are not alone.
const TURNED: [(&str, &str, &[&str]); 8] = [
    ("ch11_bvh", "method", &["--method=median"]),
    ("ch11_bvh", "leaf", &["--leaf=1"]),
    ("ch17_rendering_equation", "depth", &["--depth=1"]),
    (
        "ch20_panorama",
        "view",
        &["--view=90", "--projection=equisolid"],
    ),
    ("ch24_wide_bvh", "pieces", &["--pieces=1000"]),
    ("ch25_capstone", "depth", &["--depth=1"]),
    ("ch15_shadows", "cells", &["--cells=2"]),
    ("ch13_reflection", "depth", &["--depth=1"]),
];

#[test]
fn every_knob_says_what_it_is_and_stands_within_its_range() {
    for lesson in LESSONS {
        let knobs = knobs::of(&lesson.knobs());
        assert!(!knobs.is_empty(), "{} has knobs", lesson.name);
        for knob in knobs {
            assert!(
                knob.help.len() > 10,
                "{} --{} is explained",
                lesson.name,
                knob.name
            );
            let Kind::Number(range, _) = &knob.kind else {
                continue;
            };
            let default = knob.default.as_ref().map(|text| text.parse::<f64>());
            let inside = |value: Result<f64, _>| value.is_ok_and(|value| range.contains(&value));
            assert!(default.is_none_or(inside), "{}: {knob:?}", lesson.name);
        }
    }
}

/// A mesh of four triangles, as a file in a folder.
fn pyramid(folder: &Path) -> PathBuf {
    let mesh = folder.join("pyramid.obj");
    let faces = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    fs::write(&mesh, faces).expect("it can be written");
    mesh
}

#[test]
fn every_structure_draws_the_same_mesh_at_its_own_cost() {
    let files = tempfile::tempdir().expect("a temporary folder");
    let mesh = format!("--mesh={}", pyramid(files.path()).display());
    let chapter = find("ch11_bvh").expect("there is this chapter");
    let knobs = knobs::of(&chapter.knobs());
    let structure = knobs.iter().find(|knob| knob.name == "structure");
    let Some(Kind::Choice(words)) = structure.map(|knob| &knob.kind) else {
        panic!("the structure is one of a few words");
    };
    let drawn = words.iter().map(|word| {
        let arguments = [mesh.clone(), format!("--structure={word}")];
        ["picture", "heat"].map(|picture| draw(chapter, &arguments, picture).0)
    });
    let drawn: Vec<_> = drawn.collect();
    assert_eq!(drawn.len(), 6, "{words:?}");
    for (i, [picture, heat]) in drawn.iter().enumerate() {
        let (one, first) = (&words[i], &words[0]);
        assert!(*picture == drawn[0][0], "{one} sees what {first} sees");
        let alike = drawn[..i].iter().position(|other| other[1] == *heat);
        assert_eq!(alike.map(|i| &words[i]), None, "{one} costs as much");
    }
}

#[test]
fn the_pictures_before_the_wanted_one_are_named_and_not_drawn() {
    let out = tempfile::tempdir().expect("a temporary folder");
    let chapter = find("ch11_bvh").expect("there is this chapter");
    let stage = Stage::new(chapter.name, small(out.path()), false, progress_bar()).until("heat");
    chapter.draw(&stage).expect("it can be drawn");
    let passed = stage.passed().join(" ");
    let all = "picture stages organisations builders growth levels heat";
    assert_eq!(passed, all, "each is named, once");
    assert_eq!(stage.into_outputs().len(), 1);
}

#[test]
fn what_is_not_wanted_costs_no_pixel() {
    for lesson in LESSONS {
        let out = tempfile::tempdir().expect("a temporary folder");
        let bar = progress_bar();
        let stage = Stage::new(lesson.name, small(out.path()), false, bar.clone()).until("none");
        lesson.draw(&stage).expect("it can be drawn");
        assert!(
            stage.passed().len() > 1,
            "{} names its pictures",
            lesson.name
        );
        assert_eq!(bar.position(), 0, "{} draws no pixel", lesson.name);
        assert!(stage.into_outputs().is_empty(), "{}", lesson.name);
    }
}

#[test]
fn every_knob_changes_a_picture() {
    let files = tempfile::tempdir().expect("a temporary folder");
    let mesh = pyramid(files.path());
    let map = files.path().join("red.hdr");
    file::save(&map, &Image::from_fn(8, 4, |_, _| Rgb::new(1.0, 0.1, 0.1)))
        .expect("it can be written");
    LESSONS.par_iter().for_each(|lesson| {
        let mut usual = BTreeMap::new();
        for knob in knobs::of(&lesson.knobs()) {
            let picture = &knob.picture;
            let arguments = match (&*knob.name, &knob.kind) {
                ("mesh", _) => vec![format!("--mesh={}", mesh.display())],
                ("environment", _) => vec![format!("--environment={}", map.display())],
                ("layout", _) => vec![
                    format!("--environment={}", map.display()),
                    "--layout=cross".to_owned(),
                ],
                _ => turned(lesson, &knob),
            };
            let before = usual
                .entry(picture.clone())
                .or_insert_with(|| draw(lesson, &[], picture));
            let after = draw(lesson, &arguments, picture);
            assert!(
                before.0 != after.0,
                "{} {arguments:?} does not change `{picture}`",
                lesson.name
            );
            let says_so = match (&knob.kind, &knob.default) {
                (Kind::Choice(_), _) => before.1 != after.1,
                (Kind::Number(..), Some(usual)) => before.1 != after.1 || !says(&before.1, usual),
                _ => true,
            };
            assert!(
                says_so,
                "{} {arguments:?}: `{picture}` is still captioned “{}”",
                lesson.name, after.1
            );
        }
    });
}

/// Whether a text has a number among its words.
fn says(text: &str, number: &str) -> bool {
    let is_part = |c: char| c.is_ascii_digit() || c == '.';
    let mut words = text.split(|c| !is_part(c));
    let value = |word: &str| word.trim_end_matches('.').parse::<f64>().ok();
    words.any(|word| value(word).is_some() && value(word) == value(number))
}

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

fn turned(lesson: &Lesson, knob: &Knob) -> Vec<String> {
    let found = TURNED
        .iter()
        .find(|(chapter, name, _)| (*chapter, *name) == (lesson.name, &*knob.name));
    if let Some((_, _, arguments)) = found {
        return arguments.iter().map(|&word| word.to_owned()).collect();
    }
    let middle = match &knob.kind {
        Kind::Number(range, _) => (0.5 * (range.start() + range.end())).to_string(),
        _ => String::new(),
    };
    vec![format!(
        "--{}={}",
        knob.name,
        knob.example().unwrap_or(middle)
    )]
}

/// What draws small pictures into a folder.
fn small(out: &Path) -> Options {
    Options {
        width: Some(32),
        samples: Some(4),
        seed: 1,
        threads: Some(1),
        out: out.to_owned(),
    }
}

/// A picture of a chapter, as bytes, and its caption.
fn draw(lesson: &Lesson, arguments: &[String], picture: &str) -> (Vec<u8>, String) {
    let out = tempfile::tempdir().expect("a temporary folder");
    let stage = Stage::new(lesson.name, small(out.path()), false, progress_bar()).until(picture);
    let knobs = lesson
        .turn(arguments)
        .unwrap_or_else(|error| panic!("{}: {error}", lesson.name));
    lesson
        .draw_turned(&stage, &knobs)
        .unwrap_or_else(|error| panic!("{} {arguments:?}: {error}", lesson.name));
    let outputs = stage.into_outputs();
    let last = outputs
        .last()
        .unwrap_or_else(|| panic!("{} draws", lesson.name));
    assert!(
        last.png.ends_with(Path::new(picture).with_extension("png")),
        "{}: nothing after `{picture}` is drawn",
        lesson.name
    );
    let bytes = fs::read(&last.png).expect("it is written");
    (bytes, last.caption.clone())
}

/// Runs a chapter small, and returns its exit code, what it said, and its folder.
fn run(chapter: &str, arguments: &[&str]) -> (Option<i32>, String, TempDir) {
    let out = tempfile::tempdir().expect("a temporary folder");
    let output = Command::cargo_bin(chapter)
        .expect("the chapter is built")
        .args(["--width", "32", "--samples", "1", "--out"])
        .arg(out.path())
        .args(arguments)
        .output()
        .expect("it runs");
    let said = [output.stdout, output.stderr].concat();
    (
        output.status.code(),
        String::from_utf8_lossy(&said).into_owned(),
        out,
    )
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
        ("ch12_phong", &["--exponent", "many"], "--exponent"),
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
            "[possible values: list, grid, two-level-grid, octree, bvh, wide-bvh]",
        ),
        (
            "ch11_bvh",
            &["--vary", "leaf=1", "--picture", "roof"],
            "there are picture, stages, organisations, builders, growth, levels, heat, speeds",
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
            "there are picture, roots, cancellation",
        ),
        ("ch03_sphere", &["--animate"], "--vary"),
    ] {
        let (code, said, _) = run(chapter, arguments);
        assert_eq!(code, Some(2), "{chapter} {arguments:?}: {said}");
        assert!(said.contains(expected), "{chapter} {arguments:?}: {said}");
        assert!(
            !said.contains("panicked") && !said.contains("error: error:"),
            "{chapter} {arguments:?}: {said}"
        );
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
}

#[test]
fn a_varied_knob_makes_a_labelled_strip_or_an_animation() {
    let (code, said, out) = run(
        "ch03_sphere",
        &["--vary", "radius=0.1,0.3,0.5", "--distance", "2"],
    );
    assert_eq!(code, Some(0), "{said}");
    let folder = out.path().join("ch03_sphere");
    let strip = file::load(&folder.join("vary_radius.png")).expect("the strip is there");
    assert!(
        strip.width() > 3 * 32 && strip.height() > 18,
        "three pictures side by side"
    );
    let picture =
        |name: &str| fs::read(folder.join(name).join("picture.png")).expect("each is kept");
    assert!(
        picture("radius_0.1") != picture("radius_0.5"),
        "they differ"
    );

    let (code, said, out) = run("ch12_phong", &["--vary", "samples=1,4"]);
    assert_eq!(code, Some(0), "{said}");
    let picture = |name: &str| {
        let folder = out.path().join("ch12_phong").join(name);
        fs::read(folder.join("picture.png")).expect("each is kept")
    };
    assert!(
        picture("samples_1") != picture("samples_4"),
        "an option beside the knobs"
    );

    let (code, said, out) = run("ch03_sphere", &["--vary", "radius=0.1,0.3", "--animate"]);
    assert_eq!(code, Some(0), "{said}");
    let bytes = fs::read(out.path().join("ch03_sphere/vary_radius.png")).expect("it is there");
    let frames = bytes.windows(4).filter(|chunk| chunk == b"fcTL").count();
    assert_eq!(frames, 2, "a frame for each value");
}

#[test]
fn what_is_not_wanted_is_not_drawn() {
    let sphere = find("ch03_sphere").expect("there is this chapter");
    let out = tempfile::tempdir().expect("a temporary folder");
    let stage = Stage::new(sphere.name, small(out.path()), false, progress_bar());
    stage
        .stopper()
        .store(true, std::sync::atomic::Ordering::Relaxed);
    sphere
        .draw(&stage)
        .expect("that it was stopped is no fault");
    assert!(
        stage.into_outputs().is_empty(),
        "nothing half drawn is written"
    );
}
