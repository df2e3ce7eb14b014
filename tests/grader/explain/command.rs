//! The command, on a workbook in Python some of whose functions are wrong.

use crate::common::command::raybook;
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use tempfile::TempDir;

/// A sphere whose far side is seen, and one that is seen beside it.
const SPHERE: &str = "
def sphere_hit(ray, within, center, radius):
    m = [o - c for o, c in zip(ray.origin, center)]
    d = ray.direction
    b = sum(x * y for x, y in zip(m, d))
    root = b * b - sum(x * x for x in m) + radius * radius
    if root < 0:
        return None
    t = -b + root ** 0.5
    return t if within.min < t < within.max else None
";

/// A program of one function, outside of any workbook; none where there is no Python.
pub fn program() -> Option<(TempDir, PathBuf)> {
    let python = Command::new("python3")
        .arg("--version")
        .stdout(Stdio::null())
        .status();
    python.ok().filter(std::process::ExitStatus::success)?;
    let home = tempfile::tempdir().expect("a temporary folder");
    let (code, said) = raybook(home.path(), &["new", "rays", "--language", "python"]);
    assert_eq!(code, 0, "{said}");
    let folder = home.path().join("rays");
    let file = folder.join("ch03_sphere.py");
    let text = fs::read_to_string(&file).expect("there is a starter");
    let (before, rest) = text.split_once("def sphere_hit(").expect("it has the stub");
    let (_, after) = rest.split_once("\ndef ").expect("another stub follows");
    fs::write(&file, format!("{before}{SPHERE}\n\ndef {after}")).expect("it can be written");
    Some((home, folder))
}

#[test]
fn a_wrong_case_is_told_in_full() {
    let Some((_home, folder)) = program() else {
        return;
    };
    let (code, said) = raybook(&folder, &["explain", "sphere_hit", "--plain"]);
    assert_eq!(code, 1, "{said}");
    for part in [
        "sphere_hit, case 1: head on",
        "Where the ray starts, in metres.",
        "Where they part",
        "t   4, and should be 2   2 too large",
        "B² − 4AC",
        "takes the far root",
        "sphere_hit_case_1.svg",
        "Chapter 3 of the book",
    ] {
        assert!(said.contains(part), "`{part}` is in: {said}");
    }
    let drawing = fs::read_to_string(folder.join(".raybook/sphere_hit_case_1.svg"));
    assert!(
        drawing.is_ok_and(|svg| svg.contains("yours: t = 4")),
        "it is drawn"
    );

    let (code, said) = raybook(
        &folder,
        &["explain", "sphere_hit", "--pixel", "48,27", "--json"],
    );
    assert_eq!(code, 1, "{said}");
    let account: serde_json::Value = serde_json::from_str(&said).expect("it is JSON");
    assert_eq!(account["case"]["verdict"], "wrong");
    assert!(
        account["steps"]
            .as_array()
            .is_some_and(|steps| steps.len() > 5)
    );
    assert!(account["partings"][0]["yours"].as_f64() > account["partings"][0]["right"].as_f64());

    // Not written yet: what is right is told all the same.
    let (code, said) = raybook(&folder, &["explain", "reflect", "--plain"]);
    assert_eq!(code, 1, "{said}");
    assert!(
        said.contains("Not written yet.") && said.contains("i·n"),
        "{said}"
    );
}

#[test]
fn what_cannot_be_explained_is_refused() {
    let Some((_home, folder)) = program() else {
        return;
    };
    let refused = [
        (vec!["ch03", "--case", "1"], "of which exercise?"),
        (vec!["sphere_hit", "--case", "999"], "there is no case 999"),
        (
            vec!["sphere_hit", "--pixel", "96,0"],
            "there is no pixel 96,0",
        ),
        (
            vec!["sphere_hit", "--pixel", "left"],
            "its column and its row are wanted",
        ),
        (vec!["solve_quadratic", "--pixel", "1,1"], "has no picture"),
        (
            vec!["sphere_hit", "--pixel", "1,1", "--case", "1"],
            "cannot be used with",
        ),
    ];
    for (words, why) in refused {
        let words = [vec!["explain"], words].concat();
        let (code, said) = raybook(&folder, &words);
        assert_eq!(code, 2, "{said}");
        assert!(said.contains(why), "`{why}` is in: {said}");
    }
}
