//! The same by commands, and what they refuse.

use super::Server;
use std::process::Command;

#[test]
fn what_the_page_shows_as_command_draws_the_chapter() {
    let out = tempfile::tempdir().expect("a temporary folder");
    let output = Command::new(env!("CARGO_BIN_EXE_raybook"))
        .args(["chapter", "ch03_sphere", "--radius", "0.5", "--width", "32"])
        .args(["--samples", "1", "--out"])
        .arg(out.path())
        .output()
        .expect("it runs");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
    assert!(out.path().join("ch03_sphere/roots.png").exists(), "{said}");
    let output = Command::new(env!("CARGO_BIN_EXE_raybook"))
        .args(["chapter", "3", "--radius", "7"])
        .output()
        .expect("it runs");
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2));
    assert!(said.contains("a number from 0.02 to 0.8"), "{said}");
}

#[test]
fn help_after_a_chapter_tells_its_knobs() {
    let output = Command::new(env!("CARGO_BIN_EXE_raybook"))
        .args(["chapter", "14", "--help"])
        .output()
        .expect("it runs");
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{said}");
    assert!(said.contains("--index <1..3>"), "{said}");
}

#[test]
fn an_unknown_chapter_or_a_port_in_use_is_explained() {
    let server = Server::start();
    let port = server.host.split_once(':').expect("a port").1;
    for (arguments, expected) in [
        (["--chapter", "ch99"], "ch03_sphere"),
        (["--port", port], "any port that is free"),
    ] {
        let output = Command::new(env!("CARGO_BIN_EXE_raybook"))
            .args(["present", "--no-open"])
            .args(arguments)
            .output()
            .expect("it runs");
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains(expected), "{said}");
    }
}
