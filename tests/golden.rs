//! Every chapter's binary draws the picture that was once looked at and kept, and the same bytes on one thread and on two.
//!
//! `RAYBOOK_BLESS=1 cargo test --test golden` keeps the pictures of today; look at them before you commit them.

mod common;

use assert_cmd::Command;
use common::project;
use raybook::image::compare::{Tolerance, compare};
use raybook::image::file;
use raybook::workbook::curriculum::CHAPTERS;
use std::fs;
use std::path::Path;

/// Small, so that all chapters' golden pictures weigh less than a photograph.
const WIDTH: &str = "96";

/// Enough that no pixel is a matter of luck.
const SAMPLES: &str = "4";

#[test]
fn every_chapter_draws_its_golden_picture() {
    let bless = std::env::var_os("RAYBOOK_BLESS").is_some();
    for chapter in CHAPTERS {
        let out = tempfile::tempdir().expect("a temporary folder");
        draw(chapter.name, out.path(), "2");
        let drawn = out.path().join(chapter.name).join("picture.exr");
        let golden = project("golden").join(chapter.name).join("picture.exr");
        if bless {
            fs::create_dir_all(golden.parent().expect("it has a folder"))
                .expect("the folder can be made");
            fs::copy(&drawn, &golden).expect("the picture can be kept");
        }
        let expected =
            file::load(&golden).unwrap_or_else(|e| panic!("{e}; RAYBOOK_BLESS=1 makes it"));
        let actual = file::load(&drawn).unwrap_or_else(|e| panic!("{}: {e}", chapter.name));
        compare(&expected, &actual, &Tolerance::RENDERED_AGAIN).unwrap_or_else(|difference| {
            panic!("{}: {difference}; if the change is meant, look at the picture and run RAYBOOK_BLESS=1", chapter.name)
        });
    }
}

#[test]
fn one_thread_and_two_draw_the_same_bytes() {
    for chapter in CHAPTERS {
        let (one, two) = (
            tempfile::tempdir().expect("a folder"),
            tempfile::tempdir().expect("a folder"),
        );
        draw(chapter.name, one.path(), "1");
        draw(chapter.name, two.path(), "2");
        let picture = |out: &Path| {
            fs::read(out.join(chapter.name).join("picture.exr")).expect("the picture is there")
        };
        assert!(
            picture(one.path()) == picture(two.path()),
            "{}: the picture depends on the number of threads",
            chapter.name
        );
    }
}

/// Runs a chapter's binary as a student would.
fn draw(chapter: &str, out: &Path, threads: &str) {
    Command::cargo_bin(chapter)
        .expect("every chapter has a binary")
        .args([
            "--width",
            WIDTH,
            "--samples",
            SAMPLES,
            "--threads",
            threads,
            "--out",
        ])
        .arg(out)
        .assert()
        .success();
}
