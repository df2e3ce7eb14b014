//! What the tests share.

#![allow(
    clippy::missing_errors_doc,
    clippy::missing_panics_doc,
    reason = "parts of tests: a panic is a failure, and an error is the sentence that it says"
)]

pub mod counting;
pub mod noisy;
pub mod oracle;
pub mod polygon;
pub mod rays;
pub mod source;
pub mod statistics;
pub mod whole;

use raybook::math::{interval::Interval, ray::Ray};
use raybook::shape::Shape;
use std::fmt::Write;
use std::path::PathBuf;

/// A folder or file of the project.
pub fn project(path: &str) -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join(path)
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
