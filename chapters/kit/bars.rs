//! A bar chart: a few named numbers, to be compared by length.

use crate::kit::figure::{CENTRE, Figure, LEFT, RIGHT, figure, text, write};
use crate::kit::palette::{BLUE, FAINT};
use plotters::prelude::{Color, PathElement, Rectangle};

/// Height of a bar, and the space it stands in, in pixels of the canvas.
const BAR: i32 = 76;
const ROW: i32 = 120;
/// Where the bars begin and the longest one ends, in pixels of the canvas.
const BEGIN: i32 = 620;
const END: i32 = 1580;
/// The canvas, in its pixels.
const WIDTH: u32 = 1920;
const HEAD: i32 = 150;
const FOOT: i32 = 130;

/// Bars from 0, one under the other, each with its name and its number in `unit`; under them a note.
///
/// # Errors
/// What plotters reports.
pub fn bars(title: &str, unit: &str, rows: &[(&str, f64)], note: &str) -> Figure {
    let bottom = HEAD + ROW * rows.len() as i32;
    let longest = rows.iter().fold(0.0_f64, |longest, row| longest.max(row.1));
    figure(WIDTH / 2, (bottom + FOOT) as u32 / 2, |canvas| {
        write(
            canvas,
            title,
            (WIDTH as i32 / 2, HEAD / 2),
            text(46).pos(CENTRE),
        )?;
        for (row, (name, value)) in (0..).zip(rows) {
            let middle = HEAD + ROW * row + ROW / 2;
            let end =
                BEGIN + (f64::from(END - BEGIN) * value / longest.max(f64::MIN_POSITIVE)) as i32;
            let corners = [(BEGIN, middle - BAR / 2), (end, middle + BAR / 2)];
            canvas.draw(&Rectangle::new(corners, BLUE.filled()))?;
            write(canvas, name, (BEGIN - 28, middle), text(40).pos(RIGHT))?;
            let value = format!("{value:.1} {unit}");
            write(canvas, &value, (end + 24, middle), text(40).pos(LEFT))?;
        }
        let axis = vec![(BEGIN, HEAD), (BEGIN, bottom)];
        canvas.draw(&PathElement::new(axis, FAINT.stroke_width(4)))?;
        write(
            canvas,
            note,
            (WIDTH as i32 / 2, bottom + FOOT / 2),
            text(34).pos(CENTRE),
        )
    })
}
