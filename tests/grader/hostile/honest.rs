//! Honest programs have full marks in the sandbox.

use super::{Desk, KEY, there_is};
use crate::common::executable;
use std::fs;
use std::process::Command;

const PYTHON: &str = "\
#!/usr/bin/env python3
import json, math, random, threading
from beside import ray_at
for line in open(0):
    name, *numbers = line.split()
    print('=', *ray_at([float(number) for number in numbers]))
";

const BESIDE: &str = "\
def ray_at(numbers):
    o, d, t = numbers[:3], numbers[3:6], numbers[6]
    return [o + t * d for o, d in zip(o, d)]
";

const AWK: &str = "\
#!/bin/sh
# A wrapper that becomes the program.
exec awk '{ printf \"= %.9g %.9g %.9g\\n\", $2 + $8 * $5, $3 + $8 * $6, $4 + $8 * $7; fflush() }'
";

const CPP: &str = r#"
#include <cmath>
#include <iostream>
#include <string>
#include <thread>
int main() {
    std::string name, word;
    while (std::cin >> name) {
        double x[7];
        for (double& number : x) { std::cin >> word; number = std::stod(word); }
        std::thread([&] { for (int i = 0; i < 3; i++) x[i] += x[6] * x[i + 3]; }).join();
        std::cout << "= " << x[0] << ' ' << x[1] << ' ' << x[2] << std::endl;
    }
}
"#;

const RUST: &str = r#"
use std::io;
fn main() {
    for line in io::stdin().lines().map_while(Result::ok) {
        let x: Vec<f64> = line.split(' ').skip(1).filter_map(|word| word.parse().ok()).collect();
        let at = std::thread::spawn(move || [0, 1, 2].map(|i| x[i] + x[6] * x[i + 3])).join().unwrap();
        println!("= {} {} {}", at[0], at[1], at[2]);
    }
}
"#;

fn has_full_marks(desk: &Desk, program: &str) {
    let checked = desk.check(program, "5", &[]);
    assert_eq!(checked.code, Some(0), "{program}: {}", checked.said);
    assert!(
        checked.said.contains("1 of 1 exercises are right") && !checked.said.contains(KEY),
        "{program}: {}",
        checked.said
    );
}

#[test]
fn scripts_have_full_marks() {
    let desk = Desk::new();
    executable::script(&desk.path("hand-in/by-awk"), AWK);
    has_full_marks(&desk, "by-awk");
    if there_is("python3") {
        executable::script(&desk.path("hand-in/by-python"), PYTHON);
        fs::write(desk.path("hand-in/beside.py"), BESIDE).expect("a module beside it");
        has_full_marks(&desk, "by-python");
    }
}

#[test]
fn compiled_programs_have_full_marks() {
    let desk = Desk::new();
    for (compiler, options, file, text) in [
        ("g++", &["-O1", "-pthread", "-o"][..], "honest.cpp", CPP),
        ("rustc", &["--edition", "2024", "-o"], "honest.rs", RUST),
    ] {
        if !there_is(compiler) {
            continue;
        }
        fs::write(desk.path(file), text).expect("it can be written");
        let program = format!("by-{compiler}");
        let output = Command::new(compiler)
            .args(options)
            .arg(desk.path("hand-in").join(&program))
            .arg(desk.path(file))
            .output()
            .expect("the compiler runs");
        assert!(
            output.status.success(),
            "{}",
            String::from_utf8_lossy(&output.stderr)
        );
        has_full_marks(&desk, &program);
    }
}

#[test]
fn who_trusts_a_program_is_told_what_that_means() {
    let desk = Desk::new();
    let script = format!(
        "#!/bin/sh\n: > {}\n{}",
        desk.path("made").display(),
        AWK.split_once('\n').expect("two lines").1
    );
    executable::script(&desk.path("hand-in/by-awk"), &script);
    let checked = desk.check("by-awk", "5", &[]);
    assert!(
        !desk.path("made").exists(),
        "in the sandbox nothing is written: {}",
        checked.said
    );
    let checked = desk.check("by-awk", "5", &["--trust"]);
    assert!(
        checked.code == Some(0) && checked.said.contains("runs with all your rights"),
        "{}",
        checked.said
    );
    assert!(desk.path("made").exists(), "with all rights it writes");
}

#[test]
fn what_the_sandbox_does_not_run_is_explained() {
    let desk = Desk::new();
    let elsewhere = desk.path("home/interpreter");
    executable::script(&elsewhere, "#!/bin/sh\n");
    executable::script(
        &desk.path("hand-in/elsewhere"),
        &format!("#!{}\n", elsewhere.display()),
    );
    let checked = desk.check("elsewhere", "0.3", &[]);
    assert!(
        checked.code == Some(2)
            && checked.said.contains("first line name a program elsewhere")
            && checked.said.contains("--trust"),
        "{}",
        checked.said
    );
    executable::script(
        &desk.path("hand-in/forks"),
        "#!/bin/sh\nwhile read -r q; do echo = $(date); done\n",
    );
    let checked = desk.check("forks", "0.3", &[]);
    assert!(
        checked.code == Some(1) && checked.said.contains("starts no process"),
        "{}",
        checked.said
    );
}
