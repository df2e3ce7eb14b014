//! # Wide BVH
//!
//! A processor does eight sums in the time of one. So a node gets eight children, whose boxes are tested at once, and a
//! leaf four triangles; the tree becomes a third as high, and the search as fast as those of the field's best libraries.
//!
//! New: accel/wide_bvh/mod.rs accel/wide_bvh/avx2.rs accel/wide_bvh/batch.rs accel/wide_bvh/build.rs
//! New: accel/wide_bvh/collapse.rs accel/wide_bvh/lanes.rs accel/wide_bvh/nearest.rs accel/wide_bvh/node.rs
//! New: accel/wide_bvh/pages.rs accel/wide_bvh/portable.rs accel/wide_bvh/ray.rs accel/wide_bvh/stack.rs
//! New: accel/wide_bvh/search.rs accel/wide_bvh/validate.rs accel/wide_bvh/walk.rs

use raybook::lab::chapter;
use raybook::lab::stage::{Drawn, Stage};
use std::process::ExitCode;

/// Draws the chapter's pictures.
pub(crate) fn draw(_stage: &Stage) -> Drawn {
    Ok(())
}

fn main() -> ExitCode {
    chapter::run("ch24_wide_bvh", draw)
}
