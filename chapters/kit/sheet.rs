//! A contact sheet: pictures side by side, each with its caption.

use crate::kit::palette::INK;
use crate::kit::{figure::FONT, figure::SCALE, figure::figure};
use plotters::prelude::{Color, IntoFont, Text};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use raybook::image::{Image, rgb::Rgb};
use std::error::Error;

/// White space around each tile, in pixels.
const GAP: usize = 12;

/// Pictures of equal size in rows of so many, each under its caption, on white.
///
/// # Errors
/// If a caption cannot be drawn.
///
/// # Panics
/// If there is no tile, or they differ in size.
pub fn sheet(columns: usize, tiles: &[(&str, Image)]) -> Result<Image, Box<dyn Error>> {
    let (width, height) = (tiles[0].1.width(), tiles[0].1.height());
    assert!(
        tiles
            .iter()
            .all(|(_, t)| (t.width(), t.height()) == (width, height)),
        "the tiles of a sheet have one size"
    );
    let band = (width / 14).clamp(16, 40);
    let (across, down) = (width + GAP, band + height + GAP);
    let rows = tiles.len().div_ceil(columns);
    let mut whole = Image::from_fn(columns * across + GAP, rows * down + GAP, |_, _| Rgb::WHITE);
    for (i, (text, tile)) in tiles.iter().enumerate() {
        let (left, top) = (GAP + i % columns * across, GAP / 2 + i / columns * down);
        paste(&mut whole, &caption(text, width, band)?, left, top);
        paste(&mut whole, tile, left, top + band);
    }
    Ok(whole)
}

/// A strip of white with a line of text in the middle.
fn caption(text: &str, width: usize, height: usize) -> Result<Image, Box<dyn Error>> {
    figure(width as u32, height as u32, |canvas| {
        let style = (FONT, 0.66 * (SCALE as usize * height) as f64)
            .into_font()
            .color(&INK.to_rgba());
        let middle = (
            (SCALE as usize * width / 2) as i32,
            (SCALE as usize * height / 2) as i32,
        );
        canvas.draw(&Text::new(
            text,
            middle,
            style.pos(Pos::new(HPos::Center, VPos::Center)),
        ))?;
        Ok(())
    })
}

/// Copies a picture into a larger one, its top left at (left, top).
fn paste(whole: &mut Image, part: &Image, left: usize, top: usize) {
    for y in 0..part.height() {
        for x in 0..part.width() {
            whole.set(left + x, top + y, part.at(x, y));
        }
    }
}
