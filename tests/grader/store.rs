//! What the command keeps in folders: nothing is lost to another command, to a kill, to a full disk or to damage.

use crate::common::command::raybook_with;
use raybook_grader::starter;
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

const RAYBOOK: &str = env!("CARGO_BIN_EXE_raybook");

/// A workbook whose program needs no library: it knows `ray_at`, misses every sphere, and has written nothing else.
const ANSWER: &str = r#"
fn main() {
    for line in std::io::stdin().lines() {
        let line = line.unwrap();
        let mut words = line.split_whitespace();
        let exercise = words.next();
        let n: Vec<f32> = words.map_while(|word| word.parse().ok()).collect();
        match exercise {
            Some("ray_at") => println!("= {} {} {}", n[0] + n[6] * n[3], n[1] + n[6] * n[4], n[2] + n[6] * n[5]),
            Some("sphere_hit") => println!("= none"),
            _ => println!("= todo"),
        }
    }
}
"#;

/// Makes the workbook in a folder, and returns it.
fn workbook(home: &Path) -> PathBuf {
    let folder = home.join("my-rays");
    fs::create_dir(&folder).expect("a folder");
    let manifest = "[package]\nname = \"answers\"\nedition = \"2024\"\n[[bin]]\nname = \"answer\"\npath = \"answer.rs\"\n[workspace]\n";
    for (name, text) in [
        (starter::MARKER, ""),
        ("Cargo.toml", manifest),
        ("answer.rs", ANSWER),
    ] {
        fs::write(folder.join(name), text).expect("a file");
    }
    folder
}

/// Runs the command in the workbook: its exit code, and what it said on both outputs.
fn raybook(folder: &Path, arguments: &[&str]) -> (i32, String) {
    let target = folder.join("target");
    let target = target.to_str().expect("it is text");
    raybook_with(folder, arguments, &[("CARGO_TARGET_DIR", target)])
}

fn progress(folder: &Path) -> PathBuf {
    folder.join(".raybook/progress.json")
}

/// The exercises that the progress knows, with their states.
fn known(folder: &Path) -> Vec<(String, String)> {
    let text = fs::read_to_string(progress(folder)).expect("there is progress");
    let kept: Value = serde_json::from_str(&text).expect("it is whole");
    let exercises = kept["exercises"].as_object().expect("an object");
    let state = |of: &Value| of["state"].as_str().unwrap_or_default().to_owned();
    exercises
        .iter()
        .map(|(name, of)| (name.clone(), state(of)))
        .collect()
}

fn names(folder: &Path) -> BTreeSet<String> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    entries
        .map(|entry| entry.file_name().to_string_lossy().into_owned())
        .collect()
}

#[test]
fn twelve_checks_at_once_lose_nothing() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let folder = workbook(home.path());
    assert_eq!(raybook(&folder, &["check", "ray_at"]).0, 0, "it is right");
    let all: Vec<_> = raybook_grader::cases::all()
        .iter()
        .map(|e| e.name())
        .collect();
    let others: Vec<_> = all
        .iter()
        .filter(|name| **name != "ray_at")
        .take(36)
        .collect();
    for twelve in others.chunks(12) {
        let checks = twelve.iter().map(|exercise| {
            Command::new(RAYBOOK)
                .args(["check", exercise])
                .current_dir(&folder)
                .env("CARGO_TARGET_DIR", folder.join("target"))
                .stdout(Stdio::null())
                .stderr(Stdio::null())
                .spawn()
                .expect("the command runs")
        });
        for mut check in checks.collect::<Vec<_>>() {
            let code = check.wait().expect("it ends").code();
            assert_eq!(code, Some(1), "the answers are missing or wrong");
        }
    }
    let known = known(&folder);
    assert_eq!(known.len(), 37, "every check is remembered: {known:?}");
    assert!(known.contains(&("ray_at".to_owned(), "right".to_owned())));
}

#[test]
fn damaged_progress_is_kept_aside_and_said() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let folder = workbook(home.path());
    let kept = folder.join(".raybook");
    fs::create_dir(&kept).expect("a folder");
    let mut number = 0;
    for damage in [
        &b"{\"exercises\": {\"ray_at\""[..],
        b"",
        b"[1]",
        b"{\"exercises\": 3}",
        b"\xff\0",
    ] {
        fs::write(progress(&folder), damage).expect("a file");
        let (code, said) = raybook(&folder, &[]);
        assert_eq!(code, 2, "the map cannot know it: {said}");
        assert!(
            said.contains("progress.json: this file is damaged"),
            "{said}"
        );
        assert!(said.contains("[0 of 2]"), "but shows the rest: {said}");

        let (code, said) = raybook(&folder, &["check", "ray_at"]);
        assert_eq!(code, 0, "the answers are right: {said}");
        number += 1;
        let aside = match number {
            1 => "progress.json.damaged".to_owned(),
            n => format!("progress.json.damaged.{n}"),
        };
        assert!(
            said.contains("was damaged") && said.contains(&aside),
            "{said}"
        );
        let bytes = fs::read(kept.join(&aside)).expect("it is kept");
        assert_eq!(bytes, damage, "as it was");
        assert_eq!(known(&folder), [("ray_at".to_owned(), "right".to_owned())]);
    }
}

/// Puts something into the way.
type Trap = fn(&Path);

#[test]
fn what_cannot_be_kept_does_not_keep_the_verdict_back() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let folder = workbook(home.path());
    let verdict = |said: &str| {
        said.contains("right       ray_at") || said.contains("1 of 1 exercises are right")
    };
    let traps: [(&str, Trap, &str); 3] = [
        (
            "a file instead of the folder",
            |kept| {
                fs::write(kept, "").expect("a file");
            },
            ".raybook",
        ),
        (
            "a folder instead of the file",
            |kept| {
                fs::create_dir_all(kept.join("progress.json")).expect("a folder");
            },
            "progress.json: cannot read this file: it is a folder",
        ),
        #[cfg(unix)]
        (
            "a named pipe",
            |kept| {
                fs::create_dir(kept).expect("a folder");
                let made = Command::new("mkfifo")
                    .arg(kept.join("progress.json"))
                    .status();
                assert!(made.is_ok_and(|made| made.success()), "a named pipe");
            },
            "progress.json: cannot read this file: it is a named pipe (FIFO)",
        ),
    ];
    for (what, trap, said_of_it) in traps {
        let kept = folder.join(".raybook");
        let _ = fs::remove_dir_all(&kept).or_else(|_| fs::remove_file(&kept));
        trap(&kept);
        for options in [
            &["check", "ray_at", "--plain"][..],
            &["check", "ray_at", "--json"],
        ] {
            let (code, said) = raybook(&folder, options);
            assert_eq!(code, 2, "{what}: {said}");
            let json = said.contains("\"state\": \"right\"");
            assert!(
                json || verdict(&said),
                "{what}: the verdict is said: {said}"
            );
            assert!(said.contains(said_of_it), "{what}: and why: {said}");
        }
    }
}

/// Nothing waits for somebody who writes into the pipe.
#[cfg(unix)]
#[test]
fn a_named_pipe_is_no_program() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let pipe = home.path().join("pipe");
    let made = Command::new("mkfifo").arg(&pipe).status();
    assert!(made.is_ok_and(|made| made.success()), "a named pipe");
    let pipe = pipe.to_str().expect("the name is text");
    let (code, said) = raybook(home.path(), &["check", "ray_at", "--program", pipe]);
    assert_eq!(code, 2, "{said}");
    assert!(said.contains("pipe: cannot be run"), "{said}");
}

/// A disk is full where a process may write no byte into a file.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_loses_no_verdict() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let folder = workbook(home.path());
    assert_eq!(raybook(&folder, &["check", "ray_at"]).0, 0, "it is built");
    let script = format!(
        "trap '' XFSZ; ulimit -f 0; {RAYBOOK:?} check sphere_hit --plain --program target/debug/answer --pictures out"
    );
    let output = Command::new("/bin/sh")
        .args(["-c", &script])
        .current_dir(&folder)
        .output()
        .expect("the shell runs");
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    let (told, error) = (text(&output.stdout), text(&output.stderr));
    assert_eq!(output.status.code(), Some(2), "{told}{error}");
    assert!(
        told.contains("sphere_hit") && told.contains("Next: mend sphere_hit"),
        "{told}"
    );
    assert!(
        error.contains("out/sphere_hit.png: cannot write this file: "),
        "{error}"
    );
    assert_eq!(
        names(&folder.join("out")),
        BTreeSet::new(),
        "nothing half-written is left"
    );
}

/// All files of a workbook, with how long they are.
fn whole(folder: &Path) -> Vec<(PathBuf, u64)> {
    fn below(folder: &Path, files: &mut Vec<(PathBuf, u64)>) {
        for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
            match entry.metadata() {
                Ok(of) if of.is_dir() => below(&entry.path(), files),
                of => files.push((entry.path(), of.map_or(0, |of| of.len()))),
            }
        }
    }
    let mut files = Vec::new();
    below(folder, &mut files);
    for (path, _) in &mut files {
        *path = path.strip_prefix(folder).unwrap_or(path).to_owned();
    }
    files.sort();
    files
}

/// Starts `raybook new`, and kills it after a while; whether it was still at work.
fn killed(home: &Path, name: &str, after: Duration) -> bool {
    let mut new = Command::new(RAYBOOK)
        .args(["new", name])
        .current_dir(home)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the command runs");
    sleep(after);
    let at_work = new.try_wait().expect("it can be asked").is_none();
    let _ = new.kill();
    new.wait().expect("it ends");
    at_work
}

#[test]
fn a_new_workbook_that_is_killed_is_there_or_not_and_can_be_made_again() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let new = |name: &str| raybook_with(home.path(), &["new", name], &[]);
    let begun = Instant::now();
    assert_eq!(new("sound").0, 0);
    let takes = begun.elapsed();
    let sound = whole(&home.path().join("sound"));
    assert!(
        sound.len() > 100,
        "a workbook has many files: {}",
        sound.len()
    );

    let mut at_work = 0;
    for number in 0..24 {
        let name = format!("rays-{number}");
        let folder = home.path().join(&name);
        // In every other round the folder is there before, and empty.
        let there_before = number % 2 == 1;
        if there_before {
            fs::create_dir(&folder).expect("a folder");
        }
        at_work += u32::from(killed(home.path(), &name, takes * number / 24));
        let placed = folder.join(starter::MARKER).exists();
        if placed || folder.exists() && !there_before {
            // All that is still missing is that the command says so, or clears up.
            let mut there = whole(&folder);
            there.retain(|(path, _)| !path.starts_with(".raybook-new.partial"));
            assert_eq!(there, sound, "{name} is whole");
        }
        if folder.join(".raybook-new.partial").exists() || !placed {
            let (code, said) = new(&name);
            assert_eq!(code, 0, "{name} is made again: {said}");
        }
        assert_eq!(whole(&folder), sound, "{name} is whole in the end");
    }
    assert!(at_work >= 6, "most were killed at work: {at_work}");
}

#[test]
fn a_new_workbook_where_one_stands() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let (code, said) = raybook_with(home.path(), &["new", "."], &[]);
    assert_eq!(code, 0, "{said}");
    assert!(home.path().join(starter::MARKER).is_file());
    let (code, said) = raybook_with(home.path(), &["new", "."], &[]);
    assert!(code == 2 && said.contains("not empty"), "{said}");
    let (code, said) = raybook_with(home.path(), &["new", "Cargo.toml"], &[]);
    assert!(code == 2 && said.contains("a file of this name"), "{said}");
}
