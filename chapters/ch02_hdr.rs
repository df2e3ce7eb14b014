//! # Hdr
//!
//! To be written.
//!
//! New:

use raybook::lab::chapter;
use raybook::lab::stage::{Drawn, Stage};
use std::process::ExitCode;

/// Draws the chapter's pictures.
pub(crate) fn draw(_stage: &Stage) -> Drawn {
    Ok(())
}

fn main() -> ExitCode {
    chapter::run("ch02_hdr", draw)
}
