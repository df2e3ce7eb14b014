//! What other machines are given: the scripts do what they say.

use super::{Course, RIGHT, text};
use std::fs;
use std::process::Command;

const COURSE: &str = "[[chapter]]\nchapter = 'ch01'\nexercises = ['ray_at']\n";

fn succeeds(command: &mut Command) -> String {
    let output = command.output().expect("it runs");
    let said = [output.stdout, output.stderr]
        .map(|bytes| String::from_utf8_lossy(&bytes).into_owned())
        .concat();
    assert!(output.status.success(), "{said}");
    said
}

#[test]
fn an_autograder_grades_a_submission() {
    let course = Course::new(COURSE);
    let (code, said) = course.say(&[
        "pack",
        "gradescope",
        "autograder.zip",
        "--course",
        "course.toml",
        "--key-file",
        "key",
    ]);
    assert_eq!(code, Some(0), "{said}");
    let source = course.path("autograder/source");
    fs::create_dir_all(course.path("autograder/submission")).expect("a folder");
    // Python's unzip, which is not ours; it leaves rights out.
    succeeds(
        Command::new("python3")
            .args(["-m", "zipfile", "-e"])
            .arg(course.path("autograder.zip"))
            .arg(&source),
    );
    succeeds(
        Command::new("chmod")
            .args(["+x"])
            .arg(source.join("raybook"))
            .arg(source.join("run_autograder"))
            .arg(source.join("setup.sh")),
    );
    for script in ["run_autograder", "setup.sh"] {
        succeeds(Command::new("sh").arg("-n").arg(source.join(script)));
    }
    fs::write(course.path("autograder/submission/answer.py"), RIGHT).expect("a hand-in");
    let run = || {
        let mut command = Command::new(source.join("run_autograder"));
        succeeds(command.env("AUTOGRADER", course.path("autograder")));
        course.json("autograder/results/results.json")
    };
    assert_eq!(run()["score"], 1.0);
    fs::write(course.path("autograder/submission/answer.py"), "def x(:").expect("another hand-in");
    assert_eq!(run()["score"], 0.0, "a new submission is graded anew");
}

#[test]
fn scripts_for_slurm_are_sound_whatever_the_folders_are_called() {
    let course = Course::new(COURSE);
    course.hand_in("eve's $(touch FORGED) class/eve.py", RIGHT);
    let hand_ins = "hand-ins/eve's $(touch FORGED) class";
    let (code, said) = course.say(&[
        "pack",
        "slurm",
        "scripts",
        "--hand-ins",
        hand_ins,
        "--course",
        "course.toml",
        "--key-file",
        "key",
        "--out",
        "the results",
        "--parts",
        "2",
    ]);
    assert_eq!(code, Some(0), "{said}");
    for part in ["1", "2"] {
        succeeds(
            Command::new("sh")
                .arg(course.path("scripts/part.sh"))
                .env("SLURM_ARRAY_TASK_ID", part)
                .current_dir(course.home.path()),
        );
    }
    succeeds(
        Command::new("sh")
            .arg("-n")
            .arg(course.path("scripts/submit.sh")),
    );
    for _ in 0..2 {
        let said = succeeds(
            Command::new("sh")
                .arg(course.path("scripts/merge.sh"))
                .current_dir(course.home.path()),
        );
        assert!(
            said.contains(" 0 to grade"),
            "the parts graded everything: {said}"
        );
    }
    assert!(text(&course.path("the results/grades.csv")).contains("eve,1,1,yes"));
    let journal = text(&course.path("the results/run.jsonl"));
    assert_eq!(
        journal.lines().filter(|line| !line.is_empty()).count(),
        1,
        "merged twice, it holds nothing twice"
    );
    assert!(!course.path("FORGED").exists(), "a name is a name");
    let (code, said) = course.say(&[
        "pack",
        "slurm",
        "scripts",
        "--hand-ins",
        "hand-ins",
        "--course",
        "course.toml",
        "--key-file",
        "key",
    ]);
    assert!(code == Some(2) && said.contains("not empty"), "{said}");
}
