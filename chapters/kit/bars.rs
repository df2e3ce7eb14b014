//! A bar chart: a few named numbers, to be compared by length.

use crate::kit::figure::{CENTRE, Canvas, Figure, LEFT, RIGHT, figure, text, write};
use crate::kit::palette::{BLUE, FAINT};
use crate::kit::stage::Drawn;
use plotters::prelude::{Color, PathElement, Rectangle};

/// Height of a bar, and of the space for a bar, in pixels of the canvas.
const BAR: i32 = 56;
const ROW: i32 = 84;
/// Where the bars begin and the longest one ends, in pixels of the canvas.
const BEGIN: i32 = 620;
const END: i32 = 1580;
/// Minimum length of a bar: a number that is nearly 0 beside the others is still seen.
const LEAST: i32 = 8;
/// The canvas, in its pixels.
const WIDTH: u32 = 1920;
const HEAD: i32 = 110;
const FOOT: i32 = 100;

/// A bar chart: bars from 0, one under the other, each with its name and its number.
#[derive(Clone, Copy, Debug)]
pub struct Bars<'a> {
    /// Above the bars.
    pub title: &'a str,
    /// Behind each number.
    pub unit: &'a str,
    /// The names and the numbers.
    pub rows: &'a [(&'a str, f64)],
    /// Below the bars.
    pub note: &'a str,
}

/// Bar charts, one below the other.
///
/// # Errors
/// What plotters reports.
pub fn bars(charts: &[Bars]) -> Figure {
    let height: i32 = charts.iter().map(Bars::height).sum();
    figure(WIDTH / 2, height as u32 / 2, |canvas| {
        let mut below = canvas.clone();
        for chart in charts {
            let (own, rest) = below.split_vertically(chart.height());
            chart.draw(&own)?;
            below = rest;
        }
        Ok(())
    })
}

impl Bars<'_> {
    /// Its height, in pixels of the canvas.
    fn height(&self) -> i32 {
        HEAD + ROW * self.rows.len() as i32 + FOOT
    }

    fn draw(&self, canvas: &Canvas) -> Drawn {
        let bottom = self.height() - FOOT;
        let centred = |words: &str, y: i32, size: i32| {
            let middle = (WIDTH as i32 / 2, y);
            write(canvas, words, middle, text(size).pos(CENTRE))
        };
        let longest = self.rows.iter().map(|row| row.1);
        let longest = longest.fold(f64::MIN_POSITIVE, f64::max);
        centred(self.title, HEAD / 2, 46)?;
        for (row, (name, value)) in (0..).zip(self.rows) {
            let middle = HEAD + ROW * row + ROW / 2;
            let length = (f64::from(END - BEGIN) * value / longest) as i32;
            let end = BEGIN + length.max(LEAST);
            let corners = [(BEGIN, middle - BAR / 2), (end, middle + BAR / 2)];
            canvas.draw(&Rectangle::new(corners, BLUE.filled()))?;
            write(canvas, name, (BEGIN - 28, middle), text(40).pos(RIGHT))?;
            let value = format!("{} {}", number(*value), self.unit);
            write(canvas, &value, (end + 24, middle), text(40).pos(LEFT))?;
        }
        let axis = vec![(BEGIN, HEAD), (BEGIN, bottom)];
        canvas.draw(&PathElement::new(axis, FAINT.stroke_width(4)))?;
        centred(self.note, bottom + FOOT / 2, 38)
    }
}

/// A number with a digit after the point, and with two digits that are not zeros in front, however small it is.
fn number(value: f64) -> String {
    let zeros = if value > 0.0 {
        -value.log10().floor()
    } else {
        0.0
    };
    let digits = (1.0 + zeros).clamp(1.0, 9.0) as usize;
    format!("{value:.digits$}")
}
