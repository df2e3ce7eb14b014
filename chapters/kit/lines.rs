//! A plot of several curves over a logarithmic axis; y is a plain number, so that log N is a straight line.

use crate::kit::{figure::FONT, figure::figure};
use crate::kit::{palette::FAINT, palette::INK};
use plotters::prelude::{
    ChartBuilder, Circle, Color, IntoFont, IntoLogRange, LineSeries, PathElement, RGBColor,
    SeriesLabelPosition, WHITE,
};
use raybook::image::Image;
use std::error::Error;

/// Size of the text, in pixels of the canvas.
const TEXT: f64 = 32.0;

/// One curve.
pub struct Line {
    /// Its name.
    pub name: String,
    /// Its colour.
    pub colour: RGBColor,
    /// Its points.
    pub points: Vec<(f64, f64)>,
    /// Whether the points are marked; a law is drawn without marks.
    pub marked: bool,
}

/// Curves over an axis of powers; y begins at 0 and ends above the highest point.
///
/// # Errors
/// What plotters reports.
pub fn lines(title: &str, x: &str, y: &str, lines: &[Line]) -> Result<Image, Box<dyn Error>> {
    let points = || lines.iter().flat_map(|line| &line.points);
    let left = points().fold(f64::INFINITY, |least, p| least.min(p.0));
    let right = points().fold(0.0_f64, |most, p| most.max(p.0));
    let top = points().fold(0.0_f64, |most, p| most.max(p.1));
    figure(900, 560, |canvas| {
        let mut chart = ChartBuilder::on(canvas)
            .margin(30)
            .margin_right(110)
            .caption(title, (FONT, 1.25 * TEXT).into_font().color(&INK))
            .x_label_area_size(110)
            .y_label_area_size(130)
            .build_cartesian_2d((left..right).log_scale(), 0.0..1.25 * top)?;
        chart
            .configure_mesh()
            .light_line_style(FAINT.mix(0.0))
            .bold_line_style(FAINT.mix(0.5))
            .x_desc(x)
            .y_desc(y)
            .x_labels(9)
            .x_label_formatter(&|v| label(*v))
            .y_labels(6)
            .y_label_formatter(&|v| format!("{v:.0}"))
            .label_style((FONT, TEXT))
            .axis_desc_style((FONT, TEXT))
            .draw()?;
        for line in lines {
            let style = line.colour.stroke_width(if line.marked { 5 } else { 3 });
            let drawn = LineSeries::new(line.points.iter().copied(), style);
            chart
                .draw_series(drawn)?
                .label(line.name.clone())
                .legend(move |(x, y)| PathElement::new([(x, y), (x + 50, y)], style));
            if line.marked {
                let dots = line.points.iter();
                let dots = dots.map(|&p| Circle::new(p, 9, line.colour.filled()));
                chart.draw_series(dots)?;
            }
        }
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::UpperLeft)
            .legend_area_size(70)
            .margin(20)
            .label_font((FONT, TEXT))
            .background_style(WHITE.mix(0.9))
            .border_style(FAINT)
            .draw()?;
        Ok(())
    })
}

/// A number of an axis: fractions as 1/n.
fn label(v: f64) -> String {
    if v < 0.999 {
        format!("1/{:.0}", 1.0 / v)
    } else {
        grouped(v)
    }
}

/// A whole number, with a thin space between the thousands.
pub fn grouped(v: f64) -> String {
    let digits = format!("{v:.0}");
    let mut grouped = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i) % 3 == 0 {
            grouped.push('\u{2009}');
        }
        grouped.push(digit);
    }
    grouped
}
