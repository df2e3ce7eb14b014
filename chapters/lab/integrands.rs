//! Functions over the unit square whose means are known, and the errors with which a pattern finds them.

use crate::lab::edge::Edge;
use crate::lab::subject::Subject;
use glam::{DVec2, Vec2};
use rayon::prelude::*;
use std::f64::consts::PI;

/// A function and its mean.
#[derive(Clone, Copy, Debug)]
pub struct Integrand {
    /// What it is.
    pub name: &'static str,
    /// Its value at a point of the unit square.
    pub value: fn(Vec2) -> f64,
    /// Its mean over the square.
    pub mean: f64,
}

/// The slanted edge: at 20° to the vertical.
const SLANTED: Edge = Edge {
    normal: DVec2::new(0.939_692_620_785_908_4, 0.342_020_143_325_668_7),
    offset: 0.1,
};

/// Squares along each side of the checker.
const SQUARES: f64 = 2.5;

/// A disc's edge, a slanted edge, something smooth, and a checker.
pub fn all() -> [Integrand; 4] {
    [
        Integrand {
            name: "disc edge",
            value: |p| f64::from(u8::from(p.as_dvec2().length_squared() < 2.0 / PI)),
            mean: 0.5,
        },
        Integrand {
            name: "slanted edge",
            value: |p| f64::from(u8::from(SLANTED.covers(p))),
            mean: SLANTED.coverage(),
        },
        Integrand {
            name: "smooth",
            value: |p| (-p.as_dvec2().length_squared()).exp(),
            mean: (0.5 * PI.sqrt() * ERF_1).powi(2),
        },
        Integrand {
            name: "checker",
            value: |p| {
                let cell = (SQUARES * p.as_dvec2()).floor().element_sum();
                cell.rem_euclid(2.0)
            },
            // Along an axis even squares have 3/5 of the side: odd sums have 2 · 3/5 · 2/5.
            mean: 0.48,
        },
    ]
}

/// erf(1).
const ERF_1: f64 = 0.842_700_792_949_714_9;

/// A measured error, and how far its true value may be from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Error {
    /// How many samples.
    pub n: usize,
    /// The root of the mean squared error.
    pub rms: f64,
    /// The lower end of its 95 % confidence interval.
    pub low: f64,
    /// The upper end.
    pub high: f64,
}

/// The errors of the means of several functions over the same n points, by so many realisations.
pub fn errors(
    subject: &Subject,
    n: usize,
    integrands: &[Integrand],
    realisations: u64,
) -> Vec<Error> {
    let realisations = subject.realisations(n, realisations);
    let squares: Vec<Vec<f64>> = (0..realisations)
        .into_par_iter()
        .map(|pixel| {
            let points = subject.points(n, pixel);
            let square = |integrand: &Integrand| {
                let sum: f64 = points.iter().map(|p| (integrand.value)(*p)).sum();
                (sum / n as f64 - integrand.mean).powi(2)
            };
            integrands.iter().map(square).collect()
        })
        .collect();
    let of = |i: usize| {
        let count = realisations as f64;
        let mean = squares.iter().map(|s| s[i]).sum::<f64>() / count;
        let off = squares.iter().map(|s| (s[i] - mean).powi(2)).sum::<f64>();
        let spread = 1.96 * (off / (count - 1.0).max(1.0) / count).sqrt();
        Error {
            n,
            rms: mean.sqrt(),
            low: (mean - spread).max(mean / 16.0).sqrt(),
            high: (mean + spread).sqrt(),
        }
    };
    (0..integrands.len()).map(of).collect()
}

/// The slope of errors on logarithmic axes, by least squares.
pub fn slope(errors: &[Error]) -> f64 {
    let points = errors.iter().map(|e| ((e.n as f64).ln(), e.rms.ln()));
    let points: Vec<_> = points.collect();
    let count = points.len() as f64;
    let (x, y) = points
        .iter()
        .fold((0.0, 0.0), |m, p| (m.0 + p.0 / count, m.1 + p.1 / count));
    let products: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    products / points.iter().map(|p| (p.0 - x).powi(2)).sum::<f64>()
}
