//! Every chapter's binary draws the picture that was once looked at and kept, and all its pictures, byte for byte, on one
//! thread as on two.
//!
//! `RAYBOOK_BLESS=1 cargo test --test golden` keeps the pictures of today; look at them before you commit them.

use assert_cmd::Command;
use raybook::image::compare::{Tolerance, compare};
use raybook::image::file;
use raybook_common::project;
use raybook_workbook::curriculum::CHAPTERS;
use rayon::prelude::*;
use std::fs;
use std::path::Path;

/// Small, so that all chapters' golden pictures weigh less than a photograph.
const WIDTH: &str = "96";

/// Enough that no pixel is a matter of luck.
const SAMPLES: &str = "4";

#[test]
fn every_chapter_draws_its_golden_picture_on_one_thread_and_on_two() {
    CHAPTERS.par_iter().for_each(|chapter| {
        let out = tempfile::tempdir().expect("a temporary folder");
        let [one, two] = ["1", "2"].map(|threads| {
            let out = out.path().join(threads);
            draw(chapter.name, &out, threads);
            out.join(chapter.name)
        });
        assert_same_files(&one, &two);
        assert_golden(chapter.name, &one.join("picture.exr"));
    });
}

/// These show times, which are never the same.
const MEASURED: [&str; 6] = [
    "ch06_triangle/cost.png",
    "ch08_grid/resolution.png",
    "ch11_bvh/builders.png",
    "ch11_bvh/speeds.png",
    "ch17_rendering_equation/error.png",
    "ch24_wide_bvh/gain.png",
];

/// The seed alone decides, in every figure.
fn assert_same_files(one: &Path, two: &Path) {
    for file in fs::read_dir(one).expect("the chapter has made its folder") {
        let file = file.expect("the folder can be read").path();
        let other = two.join(file.file_name().expect("a file has a name"));
        let bytes = |path: &Path| fs::read(path).expect("both have made it");
        assert!(
            MEASURED.iter().any(|measured| file.ends_with(measured))
                || bytes(&file) == bytes(&other),
            "{} depends on the number of threads",
            file.display()
        );
    }
}

/// The picture is the one that is kept; or it is kept now.
fn assert_golden(chapter: &str, drawn: &Path) {
    let golden = project("golden").join(chapter).join("picture.exr");
    if std::env::var_os("RAYBOOK_BLESS").is_some() {
        fs::create_dir_all(golden.parent().expect("it has a folder"))
            .expect("the folder can be made");
        fs::copy(drawn, &golden).expect("the picture can be kept");
    }
    let expected = file::load(&golden).unwrap_or_else(|e| panic!("{e}; RAYBOOK_BLESS=1 makes it"));
    let actual = file::load(drawn).unwrap_or_else(|e| panic!("{chapter}: {e}"));
    compare(&expected, &actual, &Tolerance::RENDERED_AGAIN).unwrap_or_else(|difference| {
        panic!("{chapter}: {difference}; if the change is meant, look at the picture and run RAYBOOK_BLESS=1")
    });
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
