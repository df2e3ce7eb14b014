//! Chapter 22: sampling patterns, filters, and what can be measured of both.

mod areas;
mod blue_noise;
mod discrepancy;
mod distances;
mod edges;
mod errors;
mod filters;
mod legend;
mod nets;
mod patterns;
mod pens;
mod pixels;
mod poisson;
mod prefixes;
mod projections;
mod slide;
mod spectra;

use glam::Vec2;
use raybook::math::pcg;
use raybook::sample::pattern::{Pattern, find};
use raybook_chapters::lab::subject::Subject;

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
