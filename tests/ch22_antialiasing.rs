//! Chapter 22: sampling patterns, filters, and what can be measured of both.

#[path = "ch22_antialiasing/discrepancy.rs"]
mod discrepancy;
#[path = "ch22_antialiasing/edges.rs"]
mod edges;
#[path = "ch22_antialiasing/errors.rs"]
mod errors;
#[path = "ch22_antialiasing/filters.rs"]
mod filters;
#[path = "ch22_antialiasing/nets.rs"]
mod nets;
#[path = "ch22_antialiasing/patterns.rs"]
mod patterns;
#[path = "ch22_antialiasing/poisson.rs"]
mod poisson;
#[path = "ch22_antialiasing/spectra.rs"]
mod spectra;

use glam::Vec2;
use raybook::lab::sampling::subject::Subject;
use raybook::math::pcg;
use raybook::sample::pattern::{Pattern, find};

/// The pattern of this name.
#[track_caller]
fn pattern(name: &str) -> &'static Pattern {
    find(name).unwrap_or_else(|| panic!("there is no pattern {name}"))
}

/// The same, as the lab looks at it.
#[track_caller]
fn subject(name: &str) -> Subject {
    Subject::of(pattern(name))
}

/// Its points under a seed.
#[track_caller]
fn points(name: &str, n: usize, seed: u64) -> Vec<Vec2> {
    (pattern(name).points)(n, &mut pcg::stream(seed, 7))
}

/// How many points are in each of columns × rows cells.
fn counts(points: &[Vec2], columns: usize, rows: usize) -> Vec<usize> {
    let mut counts = vec![0; columns * rows];
    for p in points {
        let p = p.as_dvec2();
        let (i, j) = (
            (p.x * columns as f64) as usize,
            (p.y * rows as f64) as usize,
        );
        counts[j * columns + i] += 1;
    }
    counts
}
