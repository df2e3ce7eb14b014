//! Uniform random points.

use crate::math::pcg::Pcg;
use glam::{Vec2, vec2};
use rand::RngExt;

// ANCHOR: random_pattern
/// n points of the unit square, each anywhere with the same probability, whatever the others are (Dippé and Wold 1985).
///
/// The variance of their mean is σ²/n. They crowd here and leave gaps there.
pub fn random_pattern(n: usize, rng: &mut Pcg) -> Vec<Vec2> {
    (0..n).map(|_| vec2(rng.random(), rng.random())).collect()
}
// ANCHOR_END: random_pattern
