//! A legend beside a figure: a sample of every pen, its name, and columns of numbers.

use crate::kit::figure::{Canvas, LEFT, RIGHT, text, write};
use crate::kit::pen::Pen;
use crate::kit::stage::Drawn;

/// Height of a line, and of its text, in pixels of the canvas.
pub const LINE: i32 = 44;
const TEXT: i32 = 30;

/// Length of the sample of a pen.
const SAMPLE: i32 = 90;

/// A line of the legend: a pen, a name, and numbers.
pub type Entry = (Pen, String, Vec<String>);

/// Draws a legend with its top left at a place; `columns` are the distances from this place to the right ends of the columns of
/// numbers.
///
/// # Errors
/// What the backend reports.
pub fn draw(
    canvas: &Canvas,
    (left, top): (i32, i32),
    headings: &[&str],
    columns: &[i32],
    entries: &[Entry],
) -> Drawn {
    for (heading, column) in headings.iter().zip(columns) {
        write(
            canvas,
            heading,
            (left + column, top + LINE / 2),
            text(TEXT).pos(RIGHT),
        )?;
    }
    let first = i32::from(!headings.is_empty());
    for (i, (pen, name, numbers)) in (first..).zip(entries) {
        let y = top + i * LINE + LINE / 2;
        pen.line(canvas, &[(left, y), (left + SAMPLE, y)])?;
        pen.mark(canvas, (left + SAMPLE / 2, y))?;
        write(canvas, name, (left + SAMPLE + 14, y), text(TEXT).pos(LEFT))?;
        for (number, column) in numbers.iter().zip(columns) {
            write(canvas, number, (left + column, y), text(TEXT).pos(RIGHT))?;
        }
    }
    Ok(())
}

/// A number as people write it: with a minus sign instead of a hyphen, and 0 without any.
pub fn number(v: f64, digits: usize) -> String {
    let text = format!("{v:.digits$}");
    match text.strip_prefix('-') {
        Some(zero) if zero.chars().all(|c| c == '0' || c == '.') => zero.to_owned(),
        Some(rest) => format!("−{rest}"),
        None => text,
    }
}

/// A power of ten as people write it: 10⁻³; and 4·10⁻³, where an axis is shorter than a decade.
pub fn power_of_ten(v: f64) -> String {
    let decade = (v.log10() + 1e-6).floor();
    let factor = (v / 10_f64.powf(decade)).round();
    let factor = if factor > 1.0 {
        format!("{factor}·")
    } else {
        String::new()
    };
    let exponent = format!("{decade:.0}");
    let raised = exponent.chars().map(|c| match c.to_digit(10) {
        Some(digit) => ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'][digit as usize],
        None => '⁻',
    });
    format!("{factor}10{}", raised.collect::<String>())
}
