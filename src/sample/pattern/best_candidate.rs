//! Best candidate: of several random points, the one that is farthest from all others.

use crate::math::pcg::Pcg;
use crate::sample::pattern::dart_throwing::largest_distance;
use crate::sample::pattern::neighbours::{Neighbours, Space};
use glam::{Vec2, vec2};
use rand::RngExt;

/// Maximum number of candidates for each point.
const MOST: usize = 16;

// ANCHOR: best_candidate
/// n points, each the best of several random candidates: the one whose nearest neighbour is farthest away, over the edges too
/// (Mitchell, "Spectrally optimal sampling for distribution ray tracing", 1991).
///
/// There is one candidate more for each point, up to 16, after which more would cost much and show little.
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
