//! Projections on the axes: what an edge that lies along an axis sees of a pattern.

use glam::Vec2;

/// An axis on which points are projected.
#[derive(Clone, Copy, Debug)]
pub enum Onto {
    /// The x axis.
    X,
    /// The y axis.
    Y,
}

impl Onto {
    fn of(self, p: Vec2) -> f64 {
        match self {
            Self::X => p.x.into(),
            Self::Y => p.y.into(),
        }
    }
}

/// How many points are in each of n equal intervals of the axis, where n is the number of points.
pub fn histogram(points: &[Vec2], onto: Onto) -> Vec<usize> {
    let n = points.len();
    let mut counts = vec![0; n];
    for p in points {
        counts[((onto.of(*p) * n as f64) as usize).min(n - 1)] += 1;
    }
    counts
}

/// The share of the n equal intervals of an axis that hold a point.
///
/// 1 is a Latin hypercube, as n-rooks have it by construction (Shirley, *Discrepancy as a quality measure for sample distributions*,
/// 1991). Random points leave (1 − 1/n)ⁿ of the intervals empty, so that they fill 1 − 1/e, 63 %. A grid of √n columns fills √n of n.
pub fn filled(points: &[Vec2], onto: Onto) -> f64 {
    let counts = histogram(points, onto);
    let filled = counts.iter().filter(|count| **count > 0).count();
    filled as f64 / counts.len().max(1) as f64
}
