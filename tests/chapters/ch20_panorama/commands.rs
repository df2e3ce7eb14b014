//! The chapter's binary as a person calls it, and chapter 18's with the picture that it took.

use assert_cmd::Command;
use raybook::image::{Image, file, rgb::Rgb};
use std::path::Path;
use std::process::Output;
use tempfile::TempDir;

fn run(chapter: &str, out: &Path, arguments: &[&str]) -> Output {
    let output = Command::cargo_bin(chapter)
        .expect("the chapter is built")
        .args(["--width", "48", "--samples", "1", "--out"])
        .arg(out)
        .args(arguments)
        .output()
        .expect("it runs");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(
        !said.contains("panicked"),
        "{chapter} {arguments:?}: {said}"
    );
    output
}

fn folder() -> TempDir {
    tempfile::tempdir().expect("a temporary folder")
}

fn picture(out: &Path, chapter: &str) -> Image {
    file::load(&out.join(chapter).join("picture.exr")).expect("the picture is there")
}

#[test]
fn chapter_18_takes_the_picture_for_its_environment() {
    let out = folder();
    let output = run("ch20_panorama", out.path(), &[]);
    assert!(output.status.success(), "it draws: {output:?}");
    let map = out.path().join("ch20_panorama/picture.exr");
    let map = map.to_str().expect("its name is text");
    let output = run("ch18_environment", out.path(), &["--environment", map]);
    assert!(output.status.success(), "it reads {map}: {output:?}");
    let lit = picture(out.path(), "ch18_environment");
    let light: f32 = lit.pixels().iter().map(|pixel| pixel.g).sum();
    let mean = light / lit.pixels().len() as f32;
    assert!((0.1..10.0).contains(&mean), "the scene is lit: {mean}");
}

#[test]
fn every_projection_draws_a_disc() {
    for (projection, view) in [
        ("equidistant", "360"),
        ("equisolid", "360"),
        ("stereographic", "300"),
        ("orthographic", "180"),
    ] {
        let out = folder();
        let arguments = ["--projection", projection, "--view", view];
        let output = run("ch20_panorama", out.path(), &arguments);
        assert!(output.status.success(), "{projection}: {output:?}");
        let picture = picture(out.path(), "ch20_panorama");
        assert_eq!(
            (picture.width(), picture.height()),
            (48, 48),
            "{projection}"
        );
        let lit = picture
            .pixels()
            .iter()
            .filter(|pixel| **pixel != Rgb::BLACK);
        let share = lit.count() as f32 / (48.0 * 48.0);
        assert!(
            (share - 0.785).abs() < 0.01,
            "{projection}: a disc is π/4 of its square, not {share}"
        );
    }
}

#[test]
fn views_that_cannot_be_are_refused() {
    let cases: [(&[&str], &str); 4] = [
        (
            &["--projection", "orthographic", "--view", "200"],
            "at most 180°",
        ),
        (
            &["--projection", "equisolid", "--view", "0"],
            "from 1 to 360°",
        ),
        (
            &["--projection", "stereographic", "--view", "NaN"],
            "--view NaN",
        ),
        (&["--view", "90"], "--projection"),
    ];
    for (arguments, expected) in cases {
        let out = folder();
        let output = run("ch20_panorama", out.path(), arguments);
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(
            output.status.code(),
            Some(2),
            "{arguments:?} is wrong usage"
        );
        assert!(said.contains(expected), "{arguments:?}: {said}");
    }
}
