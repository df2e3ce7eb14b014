//! Numbers of patterns, side by side.

use crate::lab::discrepancy::{l2_star_squared, least_distance, star};
use crate::lab::subject::Subject;
use raybook::sample::pattern::dart_throwing::largest_distance;
use std::fmt::Write;
use std::time::Instant;

/// What is measured of a pattern, each the mean over realisations.
#[derive(Clone, Debug)]
pub struct Row {
    /// The pattern's name as a word.
    pub key: String,
    /// Its name as people write it.
    pub title: String,
    /// What it does with five points.
    pub five: &'static str,
    /// The star discrepancy.
    pub star: f64,
    /// The root of the mean squared L₂ star discrepancy.
    pub l2_star: f64,
    /// The least distance, as a share of the largest possible one.
    pub distance: f64,
    /// Nanoseconds that a point takes, measured here and now; the fastest of the realisations. Not of points that were given.
    pub nanoseconds: Option<f64>,
}

impl Row {
    /// Measures n points of a pattern.
    pub fn measure(subject: &Subject, n: usize, realisations: u64) -> Self {
        let realisations = subject.realisations(n, realisations);
        let mut fastest = f64::INFINITY;
        let mut row = Self {
            key: subject.key(),
            title: subject.title(),
            five: subject.pattern.five,
            star: 0.0,
            l2_star: 0.0,
            distance: 0.0,
            nanoseconds: None,
        };
        for pixel in 0..realisations {
            let start = Instant::now();
            let points = subject.points(n, pixel);
            let time = 1e9 * start.elapsed().as_secs_f64() / n as f64;
            fastest = fastest.min(time);
            row.star += star(&points) / realisations as f64;
            row.l2_star += l2_star_squared(&points) / realisations as f64;
            row.distance += least_distance(&points) / largest_distance(n) / realisations as f64;
        }
        row.l2_star = row.l2_star.sqrt();
        row.nanoseconds = (!subject.is_own()).then_some(fastest);
        row
    }
}

/// The rows as a CSV file.
pub fn csv(rows: &[Row]) -> String {
    let mut csv = "pattern,star_discrepancy,l2_star_discrepancy,least_distance_of_largest_possible,nanoseconds_per_point\n".to_owned();
    for row in rows {
        let _ = writeln!(
            csv,
            "{},{},{},{},{}",
            row.key,
            row.star,
            row.l2_star,
            row.distance,
            row.nanoseconds
                .map_or_else(String::new, |ns| ns.to_string())
        );
    }
    csv
}
