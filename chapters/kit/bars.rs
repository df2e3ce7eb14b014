//! A bar chart: a few named numbers, to be compared by length.

use crate::kit::{figure::figure, figure::text};
use crate::kit::{palette::BLUE, palette::FAINT, palette::INK};
use plotters::prelude::{Color, PathElement, Rectangle};
use plotters::style::text_anchor::HPos;
use raybook::image::Image;
use std::error::Error;

/// Height of a bar, and the space it stands in, in pixels of the canvas.
const BAR: i32 = 76;
const ROW: i32 = 120;
/// Where the bars begin and the longest one ends, in pixels of the canvas.
const LEFT: i32 = 620;
const RIGHT: i32 = 1580;
/// The canvas, in its pixels.
const WIDTH: u32 = 1920;
const HEAD: i32 = 150;
const FOOT: i32 = 130;

/// Bars from 0, one under the other, each with its name and its number in `unit`; under them a note.
///
/// # Errors
/// What plotters reports.
pub fn bars(
    title: &str,
    unit: &str,
    rows: &[(&str, f64)],
    note: &str,
) -> Result<Image, Box<dyn Error>> {
    let bottom = HEAD + ROW * rows.len() as i32;
    let longest = rows.iter().fold(0.0_f64, |longest, row| longest.max(row.1));
    figure(WIDTH / 2, (bottom + FOOT) as u32 / 2, |canvas| {
        text(
            canvas,
            title,
            (WIDTH as i32 / 2, HEAD / 2),
            46,
            HPos::Center,
            INK,
        )?;
        for (row, (name, value)) in (0..).zip(rows) {
            let middle = HEAD + ROW * row + ROW / 2;
            let end =
                LEFT + (f64::from(RIGHT - LEFT) * value / longest.max(f64::MIN_POSITIVE)) as i32;
            let corners = [(LEFT, middle - BAR / 2), (end, middle + BAR / 2)];
            canvas.draw(&Rectangle::new(corners, BLUE.filled()))?;
            text(canvas, name, (LEFT - 28, middle), 40, HPos::Right, INK)?;
            text(
                canvas,
                &format!("{value:.1} {unit}"),
                (end + 24, middle),
                40,
                HPos::Left,
                INK,
            )?;
        }
        let axis = vec![(LEFT, HEAD), (LEFT, bottom)];
        canvas.draw(&PathElement::new(axis, FAINT.stroke_width(4)))?;
        text(
            canvas,
            note,
            (WIDTH as i32 / 2, bottom + FOOT / 2),
            34,
            HPos::Center,
            INK,
        )
    })
}
