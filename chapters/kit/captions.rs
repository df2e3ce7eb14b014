//! The captions of a chapter's pictures, kept beside them: the gallery and the book have the same caption, and a caption may
//! contain what the run has measured.

use crate::kit::stage::Output;
use raybook::store::{self, StoreError};
use std::path::{Path, PathBuf};

/// The file in a chapter's folder of pictures that holds their captions: a line each, `roots: what it shows`.
pub fn file_in(folder: &Path) -> PathBuf {
    folder.join("captions.txt")
}

/// Writes the captions of a chapter's pictures into its folder.
///
/// # Errors
/// If the file cannot be written.
pub fn write(folder: &Path, outputs: &[Output]) -> Result<(), StoreError> {
    let line = |output: &Output| {
        let name = output.png.file_stem()?.to_str()?;
        let caption = output.caption.split_whitespace().collect::<Vec<_>>();
        Some(format!("{name}: {}\n", caption.join(" ")))
    };
    let text: String = outputs.iter().filter_map(line).collect();
    store::write(&file_in(folder), text.as_bytes())
}

/// The pictures and their captions in a file that [`write()`] wrote, in the order in which they were drawn.
pub fn all(text: &str) -> impl Iterator<Item = (&str, &str)> {
    text.lines().filter_map(|line| line.split_once(": "))
}

/// The caption of the picture `name` in such a file.
pub fn find<'a>(text: &'a str, name: &str) -> Option<&'a str> {
    all(text).find_map(|(picture, caption)| (picture == name).then_some(caption))
}
