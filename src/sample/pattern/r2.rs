//! R₂: a low-discrepancy sequence of irrational steps.
//!
//! ```
//! use raybook::math::pcg;
//! use raybook::sample::pattern::r2::r2;
//!
//! // Each step is the same on the torus: in x it is 1/ρ = 0.7549, in y 1/ρ² = 0.5698.
//! let points = r2(3, &mut pcg::stream(1, 0));
//! let step = (points[2] - points[1]).map(|v| v.rem_euclid(1.0));
//! assert!(step.distance(glam::vec2(0.7549, 0.5698)) < 1e-4);
//! ```

use crate::math::pcg::Pcg;
use crate::sample::pattern::halton::below_one;
use glam::{Vec2, vec2};
use rand::RngExt;

// ANCHOR: r2
/// n points of the R₂ sequence: steps of (1/ρ, 1/ρ²) around the torus from a random start, where ρ³ = ρ + 1 (Roberts, "The
/// unreasonable effectiveness of quasirandom sequences", 2018).
///
/// ρ, the plastic ratio, is for two dimensions what the golden ratio is for one: no two of the points are very close.
pub fn r2(n: usize, rng: &mut Pcg) -> Vec<Vec2> {
    const RHO: f64 = 1.324_717_957_244_746;
    let start: [f64; 2] = [rng.random(), rng.random()];
    let along = |start: f64, step: f64, i: u32| below_one((start + step * f64::from(i)).fract());
    (0..n as u32)
        .map(|i| {
            vec2(
                along(start[0], 1.0 / RHO, i),
                along(start[1], 1.0 / (RHO * RHO), i),
            )
        })
        .collect()
}
// ANCHOR_END: r2
