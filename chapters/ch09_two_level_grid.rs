//! # Two-level grid
//!
//! A coarse grid, each of whose cells is a grid of its own: fine where there is much, absent where there is nothing. This is
//! what the uniform grid lacks when a teapot stands in a stadium.
//!
//! New: accel/order.rs accel/two_level_grid/mod.rs accel/two_level_grid/levels.rs accel/two_level_grid/refine.rs
//! New: accel/two_level_grid/build.rs accel/two_level_grid/walk.rs accel/two_level_grid/validate.rs

use raybook::lab::chapter;
use raybook::lab::stage::{Drawn, Stage};
use std::process::ExitCode;

/// Draws the chapter's pictures.
pub(crate) fn draw(_stage: &Stage) -> Drawn {
    Ok(())
}

fn main() -> ExitCode {
    chapter::run("ch09_two_level_grid", draw)
}
