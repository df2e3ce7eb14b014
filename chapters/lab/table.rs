//! Numbers of patterns, side by side.

use crate::lab::discrepancy::{l2_star_squared, star};
use crate::lab::distances::relative;
use crate::lab::integrands::Integrand;
use crate::lab::legend::number;
use crate::lab::nyquist::{effective_nyquist, oscillation};
use crate::lab::pixels::correlation;
use crate::lab::projection::{Onto, filled};
use crate::lab::spectrum::Spectrum;
use crate::lab::subject::Subject;
use std::fmt::Write;
use std::time::Instant;

/// A column of numbers: its name in a file, its heading, what it means, and its digits.
pub const COLUMNS: [(&str, &str, &str, usize); 10] = [
    (
        "star_discrepancy",
        "star discrepancy",
        "largest difference between the share of points in a box and the area of the box, over all boxes from the corner (0, 0); \
        small means even",
        4,
    ),
    (
        "l2_star_discrepancy",
        "L₂ star discrepancy",
        "root mean square of this difference over all boxes; random points have √(5/(36n))",
        5,
    ),
    (
        "least_distance",
        "least distance",
        "smallest distance between two points, divided by the largest possible for n points (that of a hexagonal lattice)",
        2,
    ),
    (
        "mean_nearest_distance",
        "mean distance",
        "mean distance to the nearest neighbour, divided by the same largest distance; random points have 0.47",
        2,
    ),
    (
        "effective_nyquist",
        "effective Nyquist",
        "frequency up to which waves are hardly disturbed, in units of √n/2; a regular grid has 1, random points have 0 (Heck \
        and others 2013)",
        2,
    ),
    (
        "oscillation",
        "oscillation Ω",
        "ten times the root mean squared difference of the power from 1, from the frequency at which the power first reaches 1: \
        large means strong aliases, small means noise",
        1,
    ),
    (
        "filled_columns",
        "columns with a point",
        "share of n equal columns that hold a point; 1 is best for nearly vertical edges",
        2,
    ),
    (
        "filled_rows",
        "rows with a point",
        "share of n equal rows that hold a point; 1 is best for nearly horizontal edges",
        2,
    ),
    (
        "pixel_correlation",
        "pixel to pixel",
        "correlation of the errors of two neighbouring pixels at edges: 1 means the same error in both (stairs), 0 means noise",
        2,
    ),
    (
        "nanoseconds_per_point",
        "ns a point",
        "nanoseconds per point of the fastest realisation, measured on this machine while the page was made; never the same \
        twice",
        0,
    ),
];

/// What is measured of a pattern: means over realisations.
#[derive(Clone, Debug)]
pub struct Row {
    /// The pattern's name as a word.
    pub key: String,
    /// Its name as people write it.
    pub title: String,
    /// What it does with five points.
    pub five: &'static str,
    /// A number for each of the [`COLUMNS`], or none.
    pub numbers: [Option<f64>; COLUMNS.len()],
}

impl Row {
    /// Measures n points of a pattern, whose spectrum is known. Neighbouring pixels are compared with `samples` samples each, at
    /// `edges`.
    pub fn measure(
        subject: &Subject,
        n: usize,
        realisations: u64,
        spectrum: &Spectrum,
        (samples, edges): (usize, &[Integrand]),
    ) -> Self {
        let realisations = subject.realisations(n, realisations);
        let mut fastest = f64::INFINITY;
        let mut means = [0.0; 6];
        for pixel in 0..realisations {
            let start = Instant::now();
            let points = subject.points(n, pixel);
            fastest = fastest.min(1e9 * start.elapsed().as_secs_f64() / n as f64);
            let [least, mean] = relative(&points);
            let [x, y] = [Onto::X, Onto::Y].map(|onto| filled(&points, onto));
            let one = [star(&points), l2_star_squared(&points), least, mean, x, y];
            let share = 1.0 / realisations as f64;
            means
                .iter_mut()
                .zip(one)
                .for_each(|(sum, one)| *sum += share * one);
        }
        let radial = spectrum.radial();
        let radial: Vec<_> = radial.iter().map(|k| (k.frequency, k.value)).collect();
        let [star, l2_star_squared, least, mean, x, y] = means.map(Some);
        let time = (!subject.is_own()).then_some(fastest);
        Self {
            key: subject.key.clone(),
            title: subject.title.clone(),
            five: subject.pattern.five,
            numbers: [
                star,
                l2_star_squared.map(f64::sqrt),
                least,
                mean,
                Some(effective_nyquist(&radial, n)),
                Some(oscillation(&radial)),
                x,
                y,
                Some(correlation(subject, samples, edges)),
                time,
            ],
        }
    }

    /// The numbers as people read them.
    pub fn texts(&self) -> impl Iterator<Item = String> + '_ {
        let text = |(v, (.., digits)): (&Option<f64>, &(&str, &str, &str, usize))| {
            v.map_or_else(|| "–".to_owned(), |v| number(v, *digits))
        };
        self.numbers.iter().zip(&COLUMNS).map(text)
    }
}

/// The rows as a CSV file.
pub fn csv(rows: &[Row]) -> String {
    let names: Vec<_> = COLUMNS.iter().map(|column| column.0).collect();
    let mut csv = format!("pattern,{}\n", names.join(","));
    for row in rows {
        let number = |v: &Option<f64>| v.map_or_else(String::new, |v| v.to_string());
        let numbers: Vec<_> = row.numbers.iter().map(number).collect();
        let _ = writeln!(csv, "{},{}", row.key, numbers.join(","));
    }
    csv
}
