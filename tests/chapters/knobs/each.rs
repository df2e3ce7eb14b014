//! Each knob is explained, and changes the picture that it names.

use super::draw;
use raybook::image::{Image, file, rgb::Rgb};
use raybook_chapters::LESSONS;
use raybook_chapters::kit::knobs::{self, Kind, Knob};
use raybook_chapters::lesson::{Lesson, find};
use raybook_common::check_all;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

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

#[test]
fn every_knob_changes_a_picture() {
    let files = tempfile::tempdir().expect("a temporary folder");
    let mesh = pyramid(files.path());
    let map = files.path().join("red.hdr");
    file::save(&map, &Image::from_fn(8, 4, |_, _| Rgb::new(1.0, 0.1, 0.1)))
        .expect("it can be written");
    check_all(LESSONS, |lesson| {
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
    assert!(drawn.len() >= 6, "{words:?}");
    for (i, [picture, heat]) in drawn.iter().enumerate() {
        let (one, first) = (&words[i], &words[0]);
        assert!(*picture == drawn[0][0], "{one} sees what {first} sees");
        let alike = drawn[..i].iter().position(|other| other[1] == *heat);
        assert_eq!(alike.map(|i| &words[i]), None, "{one} costs as much");
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

/// A mesh of four triangles, as a file in a folder.
fn pyramid(folder: &Path) -> PathBuf {
    let mesh = folder.join("pyramid.obj");
    let faces = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    fs::write(&mesh, faces).expect("it can be written");
    mesh
}

/// Whether a text has a number among its words.
fn says(text: &str, number: &str) -> bool {
    let is_part = |c: char| c.is_ascii_digit() || c == '.';
    let mut words = text.split(|c| !is_part(c));
    let value = |word: &str| word.trim_end_matches('.').parse::<f64>().ok();
    words.any(|word| value(word).is_some() && value(word) == value(number))
}
