//! What the tests share.

#![allow(
    clippy::missing_errors_doc,
    clippy::missing_panics_doc,
    reason = "parts of tests: a panic is a failure, and an error is the sentence that it says"
)]

pub mod counting;
pub mod machine;
pub mod noisy;
pub mod oracle;
pub mod polygon;
pub mod rays;
pub mod source;
pub mod statistics;
pub mod whole;

use raybook::math::{interval::Interval, ray::Ray};
use raybook::shape::Shape;
use rayon::prelude::*;
use std::fmt::Write;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::path::PathBuf;

/// A folder or file of the project.
pub fn project(path: &str) -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join(path)
}

/// How many of these rays, cases or repetitions a test tries: all of them with RAYBOOK_THOROUGH in the environment, as the workflow "whole"
/// has it, and a fifth in a test that somebody waits for.
pub fn thorough(all: u32) -> u32 {
    match std::env::var_os("RAYBOOK_THOROUGH") {
        Some(_) => all,
        None => all / 5,
    }
}

/// Checks all, in parallel, and says what the first failed check says on the thread of the test, whose output is shown: what rayon's
/// threads say is shown with the test that happened to start them.
#[track_caller]
pub fn check_all<T: Send>(
    all: impl IntoParallelIterator<Item = T>,
    check: impl Fn(T) + Send + Sync,
) {
    let checked = catch_unwind(AssertUnwindSafe(|| all.into_par_iter().for_each(check)));
    let Err(failure) = checked else { return };
    match failure.downcast::<String>() {
        Ok(said) => panic!("{said}"),
        Err(failure) => resume_unwind(failure),
    }
}

/// What to do when [`measured`] is not what is measured today.
pub const STALE: &str = "RAYBOOK_BLESS=1 before the command writes golden/measured anew";

/// What the book says about a measurement: `golden/measured/<name>.md`, which its directive `{{measured name}}` shows. With RAYBOOK_BLESS
/// in the environment, what is measured today is written there first.
///
/// # Panics
/// If the file cannot be written or read.
pub fn measured(name: &str, today: &str) -> String {
    let file = project(&format!("golden/measured/{name}.md"));
    if std::env::var_os("RAYBOOK_BLESS").is_some() {
        std::fs::write(&file, today).unwrap_or_else(|e| panic!("{}: {e}", file.display()));
    }
    std::fs::read_to_string(&file).unwrap_or_else(|e| panic!("{}: {e}\n{STALE}", file.display()))
}

/// A whole number in the book: 20000 as `20 000`, with a space that does not break.
pub fn grouped(number: u64) -> String {
    let digits = number.to_string();
    if digits.len() < 5 {
        return digits;
    }
    let groups = digits
        .as_bytes()
        .rchunks(3)
        .rev()
        .map(String::from_utf8_lossy);
    groups.collect::<Vec<_>>().join("\u{a0}")
}

/// Compares a table with its snapshot in `golden/snapshots` (`cargo insta review`, or INSTA_UPDATE=always, accepts a new one).
#[track_caller]
pub fn snapshot(name: &str, table: &str) {
    insta::with_settings!({ snapshot_path => project("golden/snapshots"), prepend_module_to_snapshot => false, omit_expression => true }, {
        insta::assert_snapshot!(name, table);
    });
}

/// A line per ray: its name, and what it hits ahead of it, with five digits after the point.
pub fn hit_table(shape: &dyn Shape, rays: &[(&str, Ray)]) -> String {
    let widest = rays
        .iter()
        .map(|(name, _)| name.chars().count())
        .max()
        .unwrap_or(0);
    let mut table = String::new();
    for (name, ray) in rays {
        let answer = shape.hit(ray, Interval::AHEAD).map_or_else(
            || "miss".to_owned(),
            |hit| {
                let at = shape.surface(ray, &hit);
                format!(
                    "t {:.5}  uv {:.5}  id {}  position {:.5}  normal {:.5}  shading {:.5}  texture {:.5}",
                    hit.t, hit.uv, hit.id, at.position, *at.normal, *at.shading_normal, at.texture
                )
            },
        );
        writeln!(table, "{name:widest$}  {answer}").expect("a string takes all");
    }
    table
}
