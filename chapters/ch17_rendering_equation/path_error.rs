//! How the error of a path-traced picture shrinks: with the samples, and with the time.

use raybook::image::Image;
use crate::kit::{figure::Canvas, figure::FONT, figure::figure};
use crate::kit::{palette::BLUE, palette::FAINT, palette::GREEN, palette::INK, palette::VERMILION};
use super::{strategies::STRATEGIES, strategies::View};
use raybook::render::{film::Film, path::Path};
use plotters::element::{Circle, PathElement};
use plotters::prelude::{
    ChartBuilder, Color, IntoFont, IntoLogRange, LineSeries, SeriesLabelPosition, TextStyle, WHITE,
};
use std::error::Error;
use std::time::Instant;

/// Samples per pixel, as powers of 2.
const POWERS: std::ops::RangeInclusive<u32> = 0..=5;

/// Samples per pixel, milliseconds for a picture, and the error of it.
type Measured = [f64; 3];

/// Error against samples and error against time, of each strategy; above the Cornell box, below the plates.
///
/// # Errors
/// If plotters cannot draw, or there is no camera.
pub fn plot(film: &Film) -> Result<Image, Box<dyn Error>> {
    let views = [
        ("the Cornell box", View::cornell_box()?, 6, 1.0),
        ("the plates", View::plates(1.5)?, 1, 1.5),
    ];
    let measured = views.map(|(name, view, depth, aspect)| {
        let film = Film {
            width: (48.0 * aspect) as usize,
            height: 48,
            ..*film
        };
        (name, measure(&view, &film, depth))
    });
    figure(960, 760, |canvas| {
        let panels = canvas.split_evenly((2, 2));
        for ((name, curves), row) in measured.iter().zip(panels.chunks(2)) {
            panel(
                &row[0],
                &format!("{name}: equal samples"),
                "samples per pixel",
                curves,
                0,
            )?;
            panel(
                &row[1],
                &format!("{name}: equal time"),
                "milliseconds",
                curves,
                1,
            )?;
        }
        Ok(())
    })
}

/// A curve per strategy.
fn measure(view: &View, film: &Film, depth: u32) -> Vec<Vec<Measured>> {
    let curve = |strategy| {
        let path = Path {
            depth,
            sure: 3,
            strategy,
        };
        let start = Instant::now();
        let errors: Vec<_> = POWERS
            .map(|p| {
                let samples = 1 << p;
                let (_, error) = view.scatter(&Film { samples, ..*film }, path);
                (samples as f64, error)
            })
            .collect();
        // Two pictures each. A sample costs the same in all of them; timed one by one, the shortest would be off the most.
        let all: f64 = errors.iter().map(|(samples, _)| 2.0 * samples).sum();
        let cost = 1000.0 * start.elapsed().as_secs_f64() / all;
        let point = |(samples, error)| [samples, samples * cost, error];
        errors.into_iter().map(point).collect()
    };
    STRATEGIES
        .into_iter()
        .map(|(strategy, _)| curve(strategy))
        .collect()
}

fn panel(
    canvas: &Canvas,
    title: &str,
    unit: &str,
    curves: &[Vec<Measured>],
    axis: usize,
) -> Result<(), Box<dyn Error>> {
    let all = || curves.iter().flatten();
    let ends = |i: usize| {
        let least = all().map(|m| m[i]).fold(f64::INFINITY, f64::min);
        let most = all().map(|m| m[i]).fold(0.0, f64::max);
        (0.8 * least, 1.25 * most)
    };
    let ((left, right), (low, high)) = (ends(axis), ends(2));
    // Plotters labels an axis from its first power of ten on.
    let least = low / 0.8;
    let low = low.min(0.99 * 10.0_f64.powf(least.log10().floor()));
    let mut chart = ChartBuilder::on(canvas)
        .margin(24)
        .caption(title, text(36))
        .x_label_area_size(84)
        .y_label_area_size(130)
        .build_cartesian_2d((left..right).log_scale(), (low..high).log_scale())?;
    chart
        .configure_mesh()
        .bold_line_style(FAINT.mix(0.5))
        .max_light_lines(0)
        .x_labels(40)
        .y_labels(40)
        .x_label_formatter(&|v| round(*v, ""))
        .y_label_formatter(&|v| round(100.0 * v, " %"))
        .x_desc(unit)
        .y_desc("error")
        .label_style(text(28))
        .axis_desc_style(text(30))
        .draw()?;
    for ((curve, (_, name)), colour) in curves.iter().zip(STRATEGIES).zip([VERMILION, GREEN, BLUE])
    {
        let points = || curve.iter().map(|m| (m[axis], m[2]));
        chart.draw_series(points().map(|p| Circle::new(p, 8, colour.filled())))?;
        chart
            .draw_series(LineSeries::new(points(), colour.stroke_width(4)))?
            .label(name)
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 50, y)], colour.stroke_width(5)));
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::LowerLeft)
        .label_font(text(28))
        .legend_area_size(70)
        .margin(20)
        .background_style(WHITE.mix(0.85))
        .draw()?;
    Ok(())
}

/// A round number, 1, 2 or 5 with zeros: so that labels do not overlap, others have none.
fn round(v: f64, unit: &str) -> String {
    let first = v / 10.0_f64.powf((v.log10() + 1e-9).floor());
    let is_round = [1.0, 2.0, 5.0].iter().any(|r| (first - r).abs() < 0.01);
    if is_round {
        format!("{v:.0}{unit}")
    } else {
        String::new()
    }
}

fn text(size: u32) -> TextStyle<'static> {
    (FONT, size).into_font().color(&INK)
}
