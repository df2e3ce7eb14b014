//! The slide's table: a line for each measure, the best pattern marked, and how often each pattern is the best and the worst.

use super::measure::Measure;
use super::{FIRST, LETTERS};
use crate::kit::figure::{Canvas, LEFT, RIGHT, text, write};
use crate::kit::palette::BLUE;
use crate::kit::stage::Drawn;
use crate::lab::legend::number;
use plotters::prelude::{Color, Rectangle};

/// Where the table is, in pixels of the canvas: its first line, the distance of its lines, the right end of its first column of
/// numbers, and the distance of the columns.
const TOP: i32 = 1510;
const LINE: i32 = 54;
const NUMBERS: i32 = 1400;
const APART: i32 = 400;

/// Draws the measures of the patterns with these titles.
pub(super) fn draw(canvas: &Canvas, titles: &[&str], measures: &[Measure]) -> Drawn {
    let name = |words: &str, y: i32| write(canvas, words, (FIRST, y), text(LETTERS).pos(LEFT));
    let column = |i: usize| NUMBERS + APART * i as i32;
    let cell = |words: &str, i: usize, y: i32| {
        write(canvas, words, (column(i), y), text(LETTERS).pos(RIGHT))
    };
    name("smaller is better; the best is marked", TOP)?;
    for (i, title) in titles.iter().enumerate() {
        cell(title, i, TOP)?;
    }
    for (line, measure) in (1..).zip(measures) {
        let y = TOP + line * LINE;
        name(&measure.name, y)?;
        if let Some(best) = measure.winner() {
            let corners = [(column(best) - 200, y - 25), (column(best) + 16, y + 27)];
            canvas.draw(&Rectangle::new(corners, BLUE.mix(0.2).filled()))?;
            write(
                canvas,
                "●",
                (column(best) - 180, y),
                text(LETTERS).pos(LEFT),
            )?;
        }
        for (i, v) in measure.numbers.iter().enumerate() {
            cell(&number(*v, measure.digits), i, y)?;
        }
    }
    let last = TOP + LINE * (measures.len() as i32 + 1);
    name("how often the best / the worst", last)?;
    for i in 0..titles.len() {
        let won = measures.iter().filter(|m| m.winner() == Some(i)).count();
        let lost = measures.iter().filter(|m| m.loser() == Some(i)).count();
        cell(&format!("{won} / {lost}"), i, last)?;
    }
    Ok(())
}
