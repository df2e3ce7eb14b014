//! Attacks and honest hand-ins in one run: each has the verdict that it has alone, and nothing else happens.

use super::{RIGHT, text};
use crate::hostile::attacks::{KNOWS, PYTHON};
use crate::hostile::{Desk, there_is};
use raybook_common::thorough;
use std::fs;
use std::process::Command;

const HONEST: u32 = 60;

#[test]
fn every_attack_and_every_honest_hand_in_has_its_verdict_in_one_run() {
    if !there_is("python3") {
        return;
    }
    let desk = Desk::new();
    let hand_ins = desk.path("course/hand-ins");
    let results = desk.path("results");
    fs::create_dir(&hand_ins).expect("a folder");
    for (name, body) in PYTHON {
        let program = desk.filled(&format!("{KNOWS}{body}\n"));
        fs::write(hand_ins.join(name).with_extension("py"), program).expect("a hand-in");
    }
    for i in 0..thorough(HONEST) {
        fs::write(
            hand_ins.join(format!("honest{i}.py")),
            format!("# {i}\n{RIGHT}"),
        )
        .expect("a hand-in");
    }
    // Processor time: enough for an honest program however busy the machine is, and little for those that never end.
    let course = "[limits]\nanswer_seconds = 1.5\nexercise_seconds = 3\n[[chapter]]\nchapter = 'ch01'\nexercises = ['ray_at']\n";
    fs::write(desk.path("course/course.toml"), course).expect("the course");
    let before = desk.files();
    let output = Command::new(env!("CARGO_BIN_EXE_raybook"))
        .args([
            "grade",
            "course/hand-ins",
            "--course",
            "course/course.toml",
            "--key-file",
            "course/key",
            "--out",
            "results",
        ])
        .current_dir(desk.path(""))
        .env("RAYBOOK_TEST_SECRET", "env-secret-7Tk")
        .output()
        .expect("the command runs");
    let said = [output.stdout, output.stderr]
        .map(|bytes| String::from_utf8_lossy(&bytes).into_owned())
        .concat();
    assert_eq!(
        output.status.code(),
        Some(0),
        "everything is graded: {said}"
    );
    assert_eq!(desk.processes(), Vec::<String>::new(), "nothing goes on");
    let after = desk.files();
    for (path, state) in &before {
        assert!(
            *path == desk.path("") || after.get(path) == Some(state),
            "{} changed",
            path.display()
        );
    }
    let made: Vec<_> = after
        .keys()
        .filter(|path| !before.contains_key(*path) && !path.starts_with(&results))
        .collect();
    assert!(made.is_empty(), "{made:?}");
    let grade_of = |student: &str| text(&results.join("students").join(student).join("grade.json"));
    let points = |student: &str| -> f64 {
        let grade = grade_of(student);
        let grade: serde_json::Value = serde_json::from_str(&grade).expect("it is JSON");
        assert_eq!(grade["complete"], true, "{student}");
        grade["points"].as_f64().expect("a number")
    };
    for i in 0..thorough(HONEST) {
        let name = format!("honest{i}");
        assert_eq!(points(&name), 1.0, "{name}: {said}\n{}", grade_of(&name));
    }
    for (name, _) in PYTHON {
        assert!(points(name) < 0.5, "{name}");
        for file in ["index.html", "results.json", "grade.json"] {
            let told = text(&results.join("students").join(name).join(file));
            for secret in [crate::hostile::KEY, "env-secret-7Tk", "REACHED", "\u{1b}"] {
                assert!(
                    !told.contains(secret),
                    "{name}: {file} tells {secret:?}: {told}"
                );
            }
        }
    }
}
