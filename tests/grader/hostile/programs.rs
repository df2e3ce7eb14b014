//! Whole hand-ins that attack, checked by the command: the verdict, and that nothing happened.

use super::attacks::{CPP, KNOWS, PYTHON, RUST, SHELL};
use super::{Checked, Desk, KEY, there_is};
use crate::common::executable;
use rayon::prelude::*;
use std::process::Command;

impl Desk {
    /// A text with the paths of this desk.
    pub fn filled(&self, text: &str) -> String {
        text.replace("@@raybook", env!("CARGO_BIN_EXE_raybook"))
            .replace("@course", &self.path("course").display().to_string())
            .replace("@home", &self.path("home").display().to_string())
    }

    /// Checks the program, which is in the hand-in: what happened that must not.
    fn attack(&self, name: &str) -> Vec<String> {
        let link = |to: &str, name: &str| {
            std::os::unix::fs::symlink(self.path(to), self.path("hand-in").join(name))
        };
        link("course/key", "link").expect("a link");
        link("", "up").expect("a link");
        std::fs::write(self.path("hand-in/data"), "data").expect("a file");
        let before = self.files();
        // Once: each further question would only start it anew. `class::hostile` asks all.
        let Checked { code, said } = self.check(name, "0.3", &["--case", "1"]);
        let after = self.files();
        let mut happened = Vec::new();
        let mut never = |what: bool, how: &str| {
            if what {
                happened.push(format!("{name}: {how}: {said}"));
            }
        };
        never(
            code != Some(1),
            "it is right, or the grader does not end by itself",
        );
        never(!said.contains("ray_at"), "there is no verdict");
        for secret in [KEY, "env-secret-7Tk", "= FORGED", "REACHED"] {
            never(said.contains(secret), &format!("`{secret}` is told"));
        }
        for (path, state) in &before {
            never(
                after.get(path) != Some(state),
                &format!("{} changed", path.display()),
            );
        }
        never(after.len() != before.len(), "files were made");
        let left = self.processes();
        never(!left.is_empty(), &format!("of it goes on {left:?}"));
        happened
    }
}

#[test]
fn no_hostile_script_has_an_effect() {
    let scripts = |list: &[(&'static str, &'static str)], first: &str| -> Vec<_> {
        let text = |body: &str| format!("{first}{body}\n");
        list.iter()
            .map(|&(name, body)| (name, text(body)))
            .collect()
    };
    let mut all = scripts(SHELL, "#!/bin/sh\n");
    if there_is("python3") {
        all.extend(scripts(PYTHON, KNOWS));
        assert!(all.len() >= 40, "the table is whole");
    }
    let happened = all.par_iter().flat_map(|(name, text)| {
        let desk = Desk::new();
        executable::script(&desk.path("hand-in").join(name), &desk.filled(text));
        desk.attack(name)
    });
    let happened: Vec<_> = happened.collect();
    assert!(happened.is_empty(), "{}", happened.join("\n\n"));
    for forged in [
        "/tmp/FORGED",
        "/tmp/raybook-FORGED",
        "/var/tmp/FORGED",
        "/dev/shm/FORGED",
        "/run/FORGED",
        "/etc/FORGED",
    ] {
        assert!(
            !std::path::Path::new(forged).exists(),
            "{forged} was not made"
        );
    }
}

#[test]
fn no_hostile_compiled_program_has_an_effect() {
    for (compiler, options, file, text) in [
        ("g++", &["-O1", "-o"][..], "hostile.cpp", CPP),
        ("rustc", &["--edition", "2024", "-o"], "hostile.rs", RUST),
    ] {
        if !there_is(compiler) {
            continue;
        }
        let desk = Desk::new();
        let source = desk.path(file);
        std::fs::write(&source, desk.filled(text)).expect("it can be written");
        let program = desk.path("hand-in/program");
        let output = Command::new(compiler)
            .args(options)
            .arg(&program)
            .arg(&source)
            .output();
        let output = output.expect("the compiler runs");
        assert!(
            output.status.success(),
            "{}",
            String::from_utf8_lossy(&output.stderr)
        );
        let happened = desk.attack("program");
        assert!(happened.is_empty(), "{file}: {}", happened.join("\n\n"));
    }
}

#[test]
fn what_lies_in_the_hand_ins_folder_is_hidden_too_if_it_is_the_courses() {
    let desk = Desk::new();
    let text = "#!/bin/sh\nread -r line < key; echo \"$line\"; read -r line < golden/ch01_rays/ray_at.txt; echo \"$line\"; read -r line < mine; echo \"$line\"\n";
    executable::script(&desk.path("course/program"), text);
    std::fs::write(desk.path("course/mine"), "my own file").expect("a file");
    let output = Command::new(env!("CARGO_BIN_EXE_raybook"))
        .args([
            "check",
            "ray_at",
            "--student",
            "eve",
            "--key-file",
            "key",
            "--golden",
            "golden",
            "--program",
            "program",
        ])
        .current_dir(desk.path("course"))
        .output()
        .expect("the command runs");
    let said = String::from_utf8_lossy(&output.stdout);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(
        said.contains("my own file"),
        "what is its own it reads: {said}"
    );
    let golden = std::fs::read_to_string(desk.path("course/golden/ch01_rays/ray_at.txt"))
        .expect("it is there");
    let golden = golden.lines().next().expect("a line");
    assert!(
        !said.contains(KEY) && !said.contains(golden),
        "neither key nor golden answers: {said}"
    );
}
