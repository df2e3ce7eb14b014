//! How the error of a path-traced picture shrinks: with the samples, and with the time.

use super::strategies::{STRATEGIES, View};
use crate::kit::axis::Axis;
use crate::kit::chart::{Chart, Corner};
use crate::kit::figure::{Canvas, Figure, figure};
use crate::kit::palette::{BLUE, GREEN, VERMILION};
use crate::kit::stage::Drawn;
use plotters::prelude::Color;
use raybook::render::film::Film;
use raybook::render::path::Path;
use std::time::Instant;

/// Samples per pixel, as powers of 2.
const POWERS: std::ops::RangeInclusive<u32> = 0..=5;

/// Samples per pixel, milliseconds for a picture, and the error of the picture.
type Measured = [f64; 3];

/// Error against samples and error against time, of each strategy; above the Cornell box, below the plates.
///
/// # Errors
/// If plotters cannot draw, or there is no camera.
pub(super) fn plot(film: &Film) -> Figure {
    let views = [
        ("the Cornell box", View::cornell_box()?, 6, 1.0),
        ("the plates", View::plates(1.5)?, 1, 1.5),
    ];
    let measured = views.map(|(name, view, depth, aspect)| {
        let film = Film {
            width: (40.0 * aspect) as usize,
            height: 40,
            ..*film
        };
        (name, measure(&view, &film, depth))
    });
    figure(960, 600, |canvas| {
        let panels = canvas.split_evenly((2, 2));
        // The legend of the lower charts is that of all four.
        let legends = [None, Some(Corner::LowerLeft)];
        for ((name, curves), (row, legend)) in measured.iter().zip(panels.chunks(2).zip(legends)) {
            panel(
                &row[0],
                &format!("{name}: equal samples"),
                "samples per pixel",
                curves,
                (0, legend.clone()),
            )?;
            panel(
                &row[1],
                &format!("{name}: equal time"),
                "milliseconds",
                curves,
                (1, legend),
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
            roulette_after: 3,
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
        // Two pictures for each number of samples. A sample costs the same in all pictures, so all are timed together: timed
        // alone, the shortest would have the largest error.
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
    (axis, legend): (usize, Option<Corner>),
) -> Drawn {
    let all = || curves.iter().flatten();
    let ends = |i: usize| {
        let least = all().map(|m| m[i]).fold(f64::INFINITY, f64::min);
        let most = all().map(|m| m[i]).fold(0.0, f64::max);
        (0.8 * least, 1.25 * most)
    };
    let ((left, right), (low, high)) = (ends(axis), ends(2));
    let low = if legend.is_some() { 0.2 * low } else { low }; // so that the legend stands below the curves
    let costs = Axis::log(left..right)
        .named(unit)
        .marks(&round_numbers(left, right));
    let errors = Axis::log(low..high)
        .named("error")
        .marks(&round_numbers(low, high))
        .format(|v| format!("{} %", (100.0 * v) as f32));
    let mut chart = Chart::new(costs, errors).titled(title).text(36);
    if let Some(corner) = legend {
        chart = chart.legend(corner);
    }
    // The second curve may lie below the third, and is wider.
    let pens = [(VERMILION, 4), (GREEN, 12), (BLUE, 4)];
    for ((curve, (_, name)), (colour, width)) in curves.iter().zip(STRATEGIES).zip(pens) {
        let points = || curve.iter().map(|m| (m[axis], m[2]));
        chart
            .dots(points(), 6 + width as i32 / 2, colour.filled())
            .line(points(), colour.stroke_width(width))
            .named(name);
    }
    chart.draw(canvas)
}

/// 1, 2 and 5 with zeros, between two numbers.
fn round_numbers(low: f64, high: f64) -> Vec<f64> {
    let decades = low.log10().floor() as i32..=high.log10().floor() as i32;
    let numbers = decades.flat_map(|power| [1.0, 2.0, 5.0].map(|v| v * 10.0_f64.powi(power)));
    numbers.filter(|v| (low..=high).contains(v)).collect()
}
