//! The `raybook` command as a newcomer meets it.

use assert_cmd::Command;
use raybook_workbook::curriculum::CHAPTERS;
use std::fs;

fn raybook() -> Command {
    Command::cargo_bin("raybook").expect("the command is built")
}

#[test]
fn alone_it_prints_the_course_map_and_the_next_step() {
    let output = raybook().output().expect("it runs");
    let text = String::from_utf8(output.stdout).expect("it prints text");
    for chapter in CHAPTERS {
        assert!(
            text.contains(chapter.title),
            "the map lacks {}",
            chapter.name
        );
    }
    assert!(
        text.contains("cargo run --release -- tour"),
        "the next step is the tour"
    );
}

#[test]
fn who_has_only_the_command_is_told_its_name() {
    let output = raybook().env_remove("CARGO").output().expect("it runs");
    let text = String::from_utf8(output.stdout).expect("it prints text");
    assert!(
        text.contains("raybook tour") && !text.contains("cargo"),
        "{text}"
    );
}

#[test]
fn the_tour_draws_the_chosen_chapters_and_a_gallery_whose_pictures_exist() {
    let out = tempfile::tempdir().expect("a temporary folder");
    let run = raybook()
        .args([
            "tour",
            "--only",
            "ch03,ch04",
            "--width",
            "64",
            "--samples",
            "1",
            "--seed",
            "7",
            "--threads",
            "1",
            "--out",
        ])
        .arg(out.path())
        .assert()
        .success();
    let said = String::from_utf8_lossy(&run.get_output().stdout).into_owned();
    assert!(
        said.contains("ch03_sphere") && said.contains("2 chapters in"),
        "plain lines where there is no terminal: {said}"
    );
    let page = fs::read_to_string(out.path().join("index.html")).expect("the gallery is there");
    let pictures: Vec<_> = page
        .split("src=\"")
        .skip(1)
        .filter_map(|part| part.split('"').next())
        .collect();
    assert!(
        pictures.len() >= 2,
        "both chapters have pictures: {pictures:?}"
    );
    for picture in pictures {
        assert!(
            out.path().join(picture).is_file(),
            "the gallery shows {picture}, which is not there"
        );
    }
    assert!(
        page.contains("cargo run --release --bin ch03_sphere"),
        "the gallery tells the command"
    );
    assert!(
        page.contains("shape/sphere.rs"),
        "the gallery tells what is new"
    );
    assert!(
        page.contains("book/book/ch03_sphere.html"),
        "the gallery links to the lesson"
    );
    assert_eq!(
        page.matches("<img").count(),
        page.matches(" width=\"").count(),
        "a picture's size is told before it is loaded"
    );
    assert!(!page.contains("ch01_rays"), "only what was asked for");
}

#[test]
fn the_tour_tells_the_rays_a_second_of_the_main_picture() {
    let out = tempfile::tempdir().expect("a temporary folder");
    let run = raybook()
        .args(["tour", "--only", "ch15", "--width", "96", "--out"])
        .arg(out.path())
        .assert()
        .success();
    let said = String::from_utf8_lossy(&run.get_output().stdout).into_owned();
    let line = said.lines().find(|line| line.starts_with("ch15_shadows"));
    assert!(
        line.is_some_and(|line| line.ends_with("million rays a second")),
        "beside the time: {said}"
    );
    let page = fs::read_to_string(out.path().join("index.html")).expect("the gallery is there");
    assert!(page.contains("million rays a second"), "in the gallery too");
}

#[test]
fn the_gallery_grows_chapter_by_chapter() {
    let out = tempfile::tempdir().expect("a temporary folder");
    // A file where the second chapter's folder should be: it ends the tour.
    fs::write(out.path().join("ch04_plane"), "").expect("the file can be written");
    let run = raybook()
        .args(["tour", "--only", "ch03,ch04", "--width", "32", "--out"])
        .arg(out.path())
        .assert()
        .code(2);
    let page = out.path().join("index.html");
    let said = String::from_utf8_lossy(&run.get_output().stdout).into_owned();
    let first = said.lines().next().unwrap_or_default();
    assert!(
        first.contains(&page.display().to_string()),
        "at first it says where the pictures will be: {said}"
    );
    let page = fs::read_to_string(page).expect("the gallery is there");
    assert!(
        page.contains("ch03_sphere/picture.png"),
        "with the chapter that is drawn"
    );
}

#[test]
fn a_mistyped_chapter_is_explained() {
    let run = raybook().args(["tour", "--only", "ch99"]).assert().code(2);
    let said = String::from_utf8_lossy(&run.get_output().stderr).into_owned();
    assert!(
        said.contains("ch99") && said.contains("ch03_sphere"),
        "it says what was wrong and what there is: {said}"
    );
}

#[test]
fn a_folder_that_cannot_be_written_is_explained() {
    let file = tempfile::NamedTempFile::new().expect("a temporary file");
    let run = raybook()
        .args(["tour", "--only", "ch03", "--width", "32", "--out"])
        .arg(file.path())
        .assert()
        .code(2);
    let said = String::from_utf8_lossy(&run.get_output().stderr).into_owned();
    assert!(said.contains("cannot write"), "it says what failed: {said}");
}

#[test]
fn options_out_of_range_are_explained() {
    for wrong in [
        ["--width", "0"],
        ["--samples", "0"],
        ["--threads", "0"],
        ["--width", "many"],
    ] {
        let run = raybook().arg("tour").args(wrong).assert().code(2);
        let said = String::from_utf8_lossy(&run.get_output().stderr).into_owned();
        assert!(said.contains(wrong[0]), "it names the option: {said}");
    }
}
