//! The command, as a user runs it.

use crate::common::starter::target;
use assert_cmd::Command;
use std::path::Path;

/// Runs `raybook` in a folder: its exit code, and what it said on both outputs.
pub fn raybook(folder: &Path, arguments: &[&str]) -> (i32, String) {
    raybook_with(folder, arguments, &[])
}

/// As [`raybook`], with these environment variables.
pub fn raybook_with(
    folder: &Path,
    arguments: &[&str],
    variables: &[(&str, &str)],
) -> (i32, String) {
    let output = Command::cargo_bin("raybook")
        .expect("the command is built")
        .args(arguments)
        .current_dir(folder)
        .env("CARGO_TARGET_DIR", target())
        .env("CARGO_NET_OFFLINE", "true")
        .envs(variables.iter().copied())
        .output()
        .expect("the command runs");
    let said = [output.stdout, output.stderr]
        .map(|bytes| String::from_utf8_lossy(&bytes).into_owned())
        .concat();
    (output.status.code().expect("it ends by itself"), said)
}
