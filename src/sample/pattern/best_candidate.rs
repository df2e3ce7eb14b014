//! Best candidate: of several random points, the one whose nearest neighbour is farthest away.
//!
//! ```
//! use raybook::math::pcg;
//! use raybook::sample::pattern::{best_candidate::best_candidate, random_pattern::random_pattern};
//!
//! /// The least distance between two points.
//! fn least(points: &[glam::Vec2]) -> f32 {
//!     let pairs = (0..points.len()).flat_map(|i| (0..i).map(move |j| points[i].distance(points[j])));
//!     pairs.fold(f32::INFINITY, f32::min)
//! }
//! let [best, random] = [best_candidate, random_pattern].map(|pattern| pattern(64, &mut pcg::stream(1, 0)));
//! assert!(least(&best) > 2.0 * least(&random));
//! ```

use crate::math::pcg::Pcg;
use crate::sample::pattern::dart_throwing::largest_distance;
use crate::sample::pattern::neighbours::{Neighbours, Space};
use glam::{Vec2, vec2};
use rand::RngExt;

/// Maximum number of candidates for each point.
const MOST: usize = 16;

// ANCHOR: best_candidate
/// n points, each the best of several random candidates: the candidate whose nearest neighbour is farthest away, measured over
/// the edges of the square too (Mitchell, "Spectrally optimal sampling for distribution ray tracing", 1991).
///
/// The i-th point is chosen from i candidates, but from at most 16: more would cost much and improve little.
pub fn best_candidate(n: usize, rng: &mut Pcg) -> Vec<Vec2> {
    let mut near = Neighbours::new(largest_distance(n), Space::Torus);
    for i in 0..n {
        let candidates = (0..(i + 1).min(MOST)).map(|_| {
            let p = vec2(rng.random(), rng.random());
            (near.nearest_squared(p), p)
        });
        let best = candidates.max_by(|one, other| one.0.total_cmp(&other.0));
        if let Some((_, p)) = best {
            near.push(p);
        }
    }
    near.into_points()
}
// ANCHOR_END: best_candidate
