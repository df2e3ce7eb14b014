//! `raybook chapter`: one chapter's pictures, with its knobs.

use super::{Done, chapter};
use raybook_chapters::kit::chapter::draw_as;
use std::ffi::OsString;

/// The options of `raybook chapter`.
#[derive(clap::Args)]
#[command(
    override_usage = "raybook chapter <CHAPTER> [OPTIONS]...",
    after_help = "Examples:\n  \
    raybook chapter 14 --index 2.42                      the pictures of chapter 14, with glass of another index\n  \
    raybook chapter 12 --vary exponent=1,8,64            one of its pictures at several values of a knob\n  \
    raybook chapter 14 --picture fresnel --index 2.42    one picture only, by its file's name\n  \
    raybook chapter 14 --help                            the chapter's knobs"
)]
pub struct OneChapter {
    /// The chapter (3, ch03, sphere), then the chapter's own options and knobs: `--help` after the chapter tells them
    // One list, so that whatever follows the chapter is the chapter's, `--help` too.
    #[arg(required = true, trailing_var_arg = true, value_name = "CHAPTER")]
    words: Vec<OsString>,
}

impl OneChapter {
    /// Draws what the chapter's own command draws.
    pub fn run(&self) -> Done {
        let (first, options) = self.words.split_first().ok_or("which chapter?")?;
        let lesson = chapter(&first.to_string_lossy())?;
        draw_as(
            &format!("raybook chapter {}", lesson.name),
            lesson.name,
            options,
        )?;
        Ok(true)
    }
}
