//! What other machines are given: the scripts do what they say.

use super::{Course, RIGHT, own, text, wrong_sign};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::process::Command;

const COURSE: &str = "[[chapter]]\nchapter = 'ch01'\nexercises = ['ray_at']\n";

/// Unpacks a zip with the rights of its files, as `unzip` does; refuses a date that is none.
const UNZIP: &str = "\
import datetime, os, sys, zipfile
with zipfile.ZipFile(sys.argv[1]) as packed:
    for entry in packed.infolist():
        datetime.datetime(*entry.date_time)
        os.chmod(packed.extract(entry, sys.argv[2]), entry.external_attr >> 16 & 0o777)
";

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
fn exercises_of_the_instructors_own_are_packed() {
    let course = own::class(own::ANSWERS);
    // A program is still one where it is unpacked.
    let toml = text(&course.path("course.toml"));
    let program = format!("#!/usr/bin/env python3\n{}", own::ANSWERS);
    fs::write(course.path("lenses/answers.py"), program).expect("a file");
    let rights = fs::Permissions::from_mode(0o755);
    fs::set_permissions(course.path("lenses/answers.py"), rights).expect("a program");
    let toml = toml.replace("['python3', 'answers.py']", "['answers.py']");
    fs::write(course.path("course.toml"), &toml).expect("a file");
    let how = ["--course", "course.toml"];
    let (code, said) =
        course.say(&[&["pack", "gradescope", "--key-file", "key"][..], &how].concat());
    assert_eq!(code, Some(0), "{said}");
    let source = course.path("autograder/source");
    succeeds(
        Command::new("python3")
            .args(["-c", UNZIP])
            .arg(course.path("autograder.zip"))
            .arg(&source),
    );
    let submission = course.path("autograder/submission");
    fs::create_dir_all(&submission).expect("a folder");
    for file in ["answer.py", "lens_power.py", "toward_focus.py"] {
        let from = course.path("hand-ins/ann").join(file);
        fs::copy(from, submission.join(file)).expect("a copy");
    }
    let mut autograder = Command::new(source.join("run_autograder"));
    succeeds(autograder.env("AUTOGRADER", course.path("autograder")));
    let results = course.json("autograder/results/results.json");
    assert_eq!(results["score"], 4.0, "{results:#}");

    let (code, said) = course.say(&[&["pack", "github", "class"][..], &how].concat());
    assert_eq!(code, Some(0), "{said}");
    let packed = |file: &str| text(&course.path(&format!("class/lenses/{file}")));
    assert_eq!(
        packed("lens_power.txt"),
        text(&course.path("lenses/lens_power.txt"))
    );
    let rights = fs::metadata(course.path("class/lenses/answers.py")).expect("a file");
    assert_eq!(rights.permissions().mode() & 0o100, 0o100, "it runs");

    fs::create_dir(course.path("elsewhere")).expect("a folder");
    let toml = toml.replace("'lenses'", "'../lenses'");
    fs::write(course.path("elsewhere/course.toml"), toml).expect("a file");
    let (code, said) = course.say(&[
        "pack",
        "github",
        "other",
        "--course",
        "elsewhere/course.toml",
    ]);
    assert!(
        code == Some(2) && said.contains("lies beside this file"),
        "{said}"
    );
    assert!(!course.path("other").exists(), "nothing is written");
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
        2,
        "merged twice, it holds nothing twice: the key and a result"
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

/// The scripts of a job of the workflow by their names, read by Python's reader of YAML, which is not ours; `None` where there is none.
fn steps(course: &Course, job: &str) -> Option<BTreeMap<String, String>> {
    let read =
        "import json, sys, yaml\nprint(json.dumps(yaml.load(open(sys.argv[1]), yaml.BaseLoader)))";
    let reader = Command::new("python3").args(["-c", "import yaml"]).output();
    if !reader.is_ok_and(|output| output.status.success()) {
        println!("python3 has no yaml here: the workflow is not tried");
        return None;
    }
    let workflow = succeeds(
        Command::new("python3")
            .args(["-c", read])
            .arg(course.path("class/.github/workflows/grade.yml")),
    );
    let workflow: Value = serde_json::from_str(&workflow).expect("JSON");
    assert_eq!(workflow["on"], "workflow_dispatch");
    assert_eq!(workflow["permissions"], json!({ "contents": "read" }));
    assert_eq!(
        workflow["jobs"]["part"]["strategy"]["matrix"]["part"],
        json!(["1", "2"])
    );
    let steps = workflow["jobs"][job]["steps"].as_array().expect("steps");
    let mut scripts = BTreeMap::new();
    for step in steps {
        let script = step["run"].as_str().unwrap_or_default();
        let with_key = step["env"]["COURSE_KEY"].is_string();
        assert_eq!(
            with_key,
            step["name"] == "The course key",
            "one step has the key: {step:#}"
        );
        assert!(
            !script.contains("${{"),
            "nothing is written into a script: {script}"
        );
        if let Some(name) = step["name"].as_str() {
            scripts.insert(name.to_owned(), script.to_owned());
        }
    }
    Some(scripts)
}

#[test]
fn a_workflow_for_github_grades_in_parts() {
    let course = Course::new(COURSE);
    let (code, said) = course.say(&[
        "pack",
        "github",
        "class",
        "--course",
        "course.toml",
        "--parts",
        "2",
    ]);
    assert_eq!(code, Some(0), "{said}");
    let Some(part) = steps(&course, "part") else {
        return;
    };
    let merge = steps(&course, "merge").expect("the other job");
    let runner = course.path("runner");
    fs::create_dir(&runner).expect("a folder");
    for student in ["eve", "bob", "##[add-mask]x"] {
        let path = course.path(&format!("class/hand-ins/{student}.py"));
        fs::write(path, format!("# {student}\n{}", wrong_sign())).expect("a hand-in");
    }
    succeeds(
        Command::new("chmod")
            .arg("+x")
            .arg(course.path("class/raybook")),
    );
    let run = |script: &str, variables: &[(&str, &str)]| {
        let mut command = Command::new("bash");
        command.args(["-e", "-c", script]);
        command.env("RUNNER_TEMP", &runner);
        command.envs(variables.iter().copied());
        succeeds(command.current_dir(course.path("class")))
    };
    run(&part["The course key"], &[("COURSE_KEY", super::KEY)]);
    let key = runner.join("course.key");
    assert_eq!(text(&key).trim(), super::KEY);
    let rights = fs::metadata(&key).expect("the key").permissions().mode();
    assert_eq!(rights & 0o077, 0, "nobody else reads it");
    for number in ["1", "2"] {
        let said = run(&part["Grade a part"], &[("PART", number)]);
        assert!(said.starts_with("::stop-commands::"), "{said}");
        let journal = course.path(&format!("class/journals/journal-{number}"));
        fs::create_dir_all(&journal).expect("a folder");
        fs::rename(
            course.path("class/part/run.jsonl"),
            journal.join("run.jsonl"),
        )
        .expect("the part's journal");
    }
    let said = run(&merge["Merge"], &[]);
    assert!(
        said.contains(" 0 to grade"),
        "the parts graded everything: {said}"
    );
    let said = run(&merge["Annotations"], &[]);
    assert_eq!(said.lines().count(), 3, "{said}");
    assert!(
        said.lines().all(|line| line.starts_with("::error title=")),
        "{said}"
    );
}
