//! `raybook chapter`: one chapter's pictures, with its knobs.

use super::{Done, chapter};
use raybook_chapters::kit::chapter::draw_as;
use std::ffi::OsString;

/// The options of `raybook chapter`.
#[derive(clap::Args)]
#[command(after_help = "Examples:\n  \
    raybook chapter 14 --index 2.42                      the pictures of chapter 14, with glass of another index\n  \
    raybook chapter 12 --vary exponent=1,8,64            one of its pictures at several values of a knob\n  \
    raybook chapter 14 -- --help                         the chapter's knobs")]
pub struct OneChapter {
    /// The chapter (3, ch03, sphere)
    chapter: String,
    /// The chapter's options and knobs
    #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
    options: Vec<OsString>,
}

impl OneChapter {
    /// Draws what the chapter's own command draws.
    pub fn run(&self) -> Done {
        let lesson = chapter(&self.chapter)?;
        draw_as(
            &format!("raybook chapter {}", lesson.name),
            lesson.name,
            &self.options,
        )?;
        Ok(true)
    }
}
