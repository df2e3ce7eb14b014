//! The program that cargo runs first: the tour, and the way to all else.

use assert_cmd::Command;
use std::fs;

fn course() -> Command {
    Command::cargo_bin("course").expect("the program is built")
}

#[test]
fn the_tour_is_drawn_without_the_command() {
    let out = tempfile::tempdir().expect("a temporary folder");
    let words = [
        "tour",
        "--only",
        "ch04",
        "--width",
        "32",
        "--samples",
        "1",
        "--out",
    ];
    course().args(words).arg(out.path()).assert().success();
    assert!(out.path().join("index.html").is_file());
    let captions = fs::read_to_string(out.path().join("ch04_plane/captions.txt"));
    let captions = captions.expect("the captions are there");
    assert!(captions.starts_with("picture: "), "{captions}");
}

/// Instead of cargo, a program that prints what it is told.
#[cfg(unix)]
#[test]
fn all_else_is_handed_on_to_the_command() {
    let run = course()
        .env("CARGO", "echo")
        .args(["check", "sphere_hit", "--json"])
        .assert()
        .success();
    let said = String::from_utf8_lossy(&run.get_output().stdout).into_owned();
    assert!(
        said.starts_with("run --package raybook-grader --profile ")
            && said.ends_with(" -- check sphere_hit --json\n"),
        "{said}"
    );
}

#[test]
fn without_cargo_it_says_which_command_to_use() {
    let run = course().env_remove("CARGO").arg("check").assert().code(2);
    let said = String::from_utf8_lossy(&run.get_output().stderr).into_owned();
    assert!(said.contains("start `raybook`"), "{said}");
}

#[test]
fn a_captions_file_is_read_by_the_pictures_name() {
    use raybook_chapters::kit::captions::find;
    let text = "picture: A ball: red.\nroots: Two roots.\n";
    assert_eq!(find(text, "picture"), Some("A ball: red."));
    assert_eq!(find(text, "roots"), Some("Two roots."));
    assert_eq!(find(text, "ball"), None);
}
