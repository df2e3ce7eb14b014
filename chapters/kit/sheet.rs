//! A contact sheet: pictures side by side, each with its caption.

use crate::kit::figure::{CENTRE, SCALE, figure, text, text_width, write};
use raybook::image::{Image, rgb::Rgb};
use std::error::Error;

/// Pictures put together, or why they could not be.
pub type Sheet = Result<Image, Box<dyn Error>>;

/// White space around each tile, in pixels.
const GAP: usize = 12;

/// Pictures of equal size in rows of `columns`, each under its caption, on white.
///
/// # Errors
/// If a caption cannot be drawn.
///
/// # Panics
/// If there is no tile, or they differ in size.
pub fn sheet(columns: usize, tiles: &[(impl AsRef<str>, Image)]) -> Sheet {
    let (width, height) = (tiles[0].1.width(), tiles[0].1.height());
    assert!(
        tiles
            .iter()
            .all(|(_, t)| (t.width(), t.height()) == (width, height)),
        "the tiles of a sheet have one size"
    );
    // The letters are as large in a sheet of five columns as in one of two, and larger in a high one, which is shown smaller.
    let rows = tiles.len().div_ceil(columns);
    let band = (columns * width / 36).max(rows * height / 21).clamp(20, 60);
    let (across, down) = (width + GAP, band + height + GAP);
    // All captions have one size, and leave some white between them.
    let size = 0.66 * (SCALE as usize * band) as f64;
    let room = 0.92 * (SCALE as usize * width) as f64;
    let mut widest = room;
    for (words, _) in tiles {
        widest = text_width(words.as_ref(), size)?.max(widest);
    }
    let size = size * room / widest;
    let mut whole = Image::from_fn(columns * across + GAP, rows * down + GAP, |_, _| Rgb::WHITE);
    for (i, (words, tile)) in tiles.iter().enumerate() {
        let (left, top) = (GAP + i % columns * across, GAP / 2 + i / columns * down);
        paste(
            &mut whole,
            &caption(words.as_ref(), width, band, size)?,
            left,
            top,
        );
        paste(&mut whole, tile, left, top + band);
    }
    Ok(whole)
}

/// A strip of white with a line of text in the middle, whose letters have this size in pixels of the canvas.
fn caption(words: &str, width: usize, height: usize, size: f64) -> Sheet {
    let strip = figure(width as u32, height as u32, |canvas| {
        let (wide, high) = canvas.dim_in_pixel();
        let middle = (wide as i32 / 2, high as i32 / 2);
        write(canvas, words, middle, text(size).pos(CENTRE))
    })?;
    Ok(strip.pixels)
}

/// Copies a picture into a larger one, its top left at (left, top).
fn paste(whole: &mut Image, part: &Image, left: usize, top: usize) {
    for y in 0..part.height() {
        for x in 0..part.width() {
            whole.set(left + x, top + y, part.at(x, y));
        }
    }
}
