//! Uniform random points.
//!
//! ```
//! use raybook::math::pcg;
//! use raybook::sample::pattern::random_pattern::random_pattern;
//!
//! let points = random_pattern(1000, &mut pcg::stream(1, 0));
//! let mean = points.iter().map(|p| p.x).sum::<f32>() / 1000.0;
//! assert!((mean - 0.5).abs() < 0.03); // a standard error of √(1/12/1000) = 0.009
//! ```

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
