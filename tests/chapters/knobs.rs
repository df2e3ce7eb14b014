//! Every chapter has knobs, each changes a picture, and nonsense is refused in a sentence.

mod captions;
mod each;
mod said;
mod vary;
mod wanted;

use assert_cmd::Command;
use raybook_chapters::kit::options::Options;
use raybook_chapters::kit::stage::{Stage, progress_bar};
use raybook_chapters::lesson::Lesson;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

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
