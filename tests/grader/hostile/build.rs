//! Workbooks that attack while they are built.

use super::Desk;
use crate::common::executable;
use raybook_grader::sandbox::Sandbox;
use raybook_grader::starter::{LOCK, MARKER};
use std::fs;

/// Runs while the workbook is compiled: what it reaches it writes into its program's environment.
const BUILD: &str = r#"
use std::{fs, net::TcpListener, process::{Command, Stdio}};
fn main() {
    let key = fs::read_to_string("@course/key").unwrap_or_default();
    let _ = fs::write("@course/FORGED", "x");
    let _ = fs::write("src/FORGED", "x");
    let _ = fs::write("@course/grades.csv", "eve,100");
    let _ = fs::remove_file("@course/grades.csv");
    let socket = TcpListener::bind("127.0.0.1:0").is_ok();
    for (program, arguments) in [
        ("/usr/bin/setsid", &["sh", "-c", "cd @course; sleep 600"][..]),
        ("sh", &["-c", "cd @course; sleep 600 & sleep 600"]),
    ] {
        let mut command = Command::new(program);
        // Cargo waits for whoever holds its pipes.
        command.args(arguments).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
        let _ = command.spawn();
    }
    let grader = Command::new("@@raybook").args(["exercise", "ray_at"]).output().is_ok();
    println!("cargo::rustc-env=REACHED={key}|{socket}|{grader}");
}
"#;

const PROGRAM: &str =
    r#"fn main() { for _ in std::io::stdin().lines() { println!("= {}", env!("REACHED")); } }"#;

const MANIFEST: &str = r#"
[package]
name = "workbook"
version = "0.1.0"
edition = "2024"
[[bin]]
name = "answer"
path = "src/main.rs"
[workspace]
"#;

/// More processes than a build needs.
const BOMB: &str = r#"
fn main() {
    let start = |_| std::process::Command::new("/bin/sleep").arg("600").spawn().ok();
    let _kept: Vec<_> = (0..3000).map_while(start).collect();
    std::thread::sleep(std::time::Duration::from_secs(600));
}
"#;

/// A wrapper of the compiler, which cargo starts before everything else.
const WRAPPER: &str = "#!/bin/sh\necho x > @course/FORGED\n(cd @course; sleep 600) < /dev/null > /dev/null 2>&1 &\nexec \"$@\"\n";

/// A workbook whose program is compiled after this build script ran.
fn workbook(desk: &Desk, build: &str) {
    let write = |path: &str, text: &str| {
        let path = desk.path("hand-in").join(path);
        fs::create_dir_all(path.parent().expect("a folder")).expect("folders");
        let text = text
            .replace("@@raybook", env!("CARGO_BIN_EXE_raybook"))
            .replace("@course", &desk.path("course").display().to_string())
            .replace("@hand-in", &desk.path("hand-in").display().to_string());
        fs::write(path, text).expect("a file");
    };
    write(MARKER, "");
    write("Cargo.toml", MANIFEST);
    // Cargo takes out what is not used, as it does of a workbook's.
    write("Cargo.lock", LOCK);
    write("src/main.rs", PROGRAM);
    write("build.rs", build);
    write(
        ".cargo/config.toml",
        "[build]\nrustc-wrapper = \"@hand-in/wrapper\"\n",
    );
    write("text", WRAPPER);
    executable::copy(&desk.path("hand-in/text"), &desk.path("hand-in/wrapper"));
}

#[test]
fn a_workbook_is_built_without_effect_and_nothing_goes_on() {
    let desk = Desk::new();
    workbook(&desk, BUILD);
    let before = fs::read_to_string(desk.path("course/grades.csv")).expect("grades");

    let sandbox =
        Sandbox::new([env!("CARGO_BIN_EXE_raybook").into()]).expect("the layers are there");
    let built = sandbox.build(&desk.path("hand-in")).expect("it compiles");
    assert!(
        built.file.starts_with(desk.path("hand-in/target")),
        "in a folder of its own"
    );
    assert_eq!(desk.processes(), Vec::<String>::new(), "nothing goes on");
    assert!(
        !desk.path("course/FORGED").exists(),
        "nothing is made in the course's folder"
    );
    assert!(
        !desk.path("hand-in/src/FORGED").exists(),
        "nor in its own source"
    );
    let after = fs::read_to_string(desk.path("course/grades.csv")).expect("grades");
    assert_eq!(after, before, "grades stay");
    let checked = desk.check("", "0.3", &[]);
    assert!(
        checked.code == Some(1) && checked.said.contains("|false|false"),
        "no key, no socket, no grader: {}",
        checked.said
    );
}

#[test]
fn a_build_with_too_many_processes_is_ended() {
    let desk = Desk::new();
    workbook(&desk, BOMB);
    let sandbox = Sandbox::new([]).expect("the layers are there");
    let error = sandbox
        .build(&desk.path("hand-in"))
        .expect_err("it is ended");
    assert!(error.to_string().contains("does not compile"), "{error}");
    assert_eq!(desk.processes(), Vec::<String>::new(), "nothing goes on");
}

#[test]
fn a_target_that_is_a_link_is_not_built_into() {
    let desk = Desk::new();
    fs::write(desk.path("hand-in").join(MARKER), "").expect("a file");
    std::os::unix::fs::symlink(desk.path("course"), desk.path("hand-in/target")).expect("a link");
    let sandbox = Sandbox::new([]).expect("the layers are there");
    let error = sandbox
        .build(&desk.path("hand-in"))
        .expect_err("it is refused")
        .to_string();
    assert!(error.contains("answer"), "{error}");
    assert!(!desk.path("course/debug").exists(), "nothing is built");
}
