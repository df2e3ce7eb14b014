//! # Bounding volume hierarchy
//!
//! Boxes in boxes.
//!
//! New: accel/bvh/mod.rs
use raybook::lab::chapter;
use raybook::lab::stage::{Drawn, Stage};
use std::process::ExitCode;
pub(crate) fn draw(_stage: &Stage) -> Drawn {
    Ok(())
}
fn main() -> ExitCode {
    chapter::run("ch11_bvh", draw)
}
