//! Uniform random points.

use crate::math::pcg::Pcg;
use glam::{Vec2, vec2};
use rand::RngExt;

// ANCHOR: random_pattern
/// n independent points, uniform over the unit square (Dippé and Wold 1985).
///
/// The mean of a function over the points has the variance σ²/n, where σ² is the variance of the function. The points form
/// clusters and leave gaps.
pub fn random_pattern(n: usize, rng: &mut Pcg) -> Vec<Vec2> {
    (0..n).map(|_| vec2(rng.random(), rng.random())).collect()
}
// ANCHOR_END: random_pattern
