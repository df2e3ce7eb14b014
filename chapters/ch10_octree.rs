//! # Octree
//!
//! A cell with much in it is cut in eight, and each of these again, as long as it pays: small cells where there is much to
//! tell apart, large ones where there is nothing. A ray walks from leaf to leaf, front to back.
//!
//! New: accel/octree/mod.rs accel/octree/tree.rs accel/octree/reach.rs accel/octree/build.rs accel/octree/walk.rs
//! New: accel/octree/validate.rs

use raybook::lab::chapter;
use raybook::lab::stage::{Drawn, Stage};
use std::process::ExitCode;

/// Draws the chapter's pictures.
pub(crate) fn draw(_stage: &Stage) -> Drawn {
    Ok(())
}

fn main() -> ExitCode {
    chapter::run("ch10_octree", draw)
}
