//! A Poisson disk of exactly n points, by throwing darts.
//!
//! ```
//! use raybook::sample::pattern::dart_throwing::largest_distance;
//!
//! // Four times as many points are half as far from each other.
//! assert!((largest_distance(16) - 2.0 * largest_distance(64)).abs() < 1e-12);
//! ```

use crate::math::pcg::Pcg;
use crate::sample::pattern::neighbours::{Neighbours, Space};
use glam::{Vec2, vec2};
use rand::RngExt;

/// Number of darts in a row that miss before the distance shrinks.
const MISSES: u32 = 100;

/// The factor by which the distance shrinks then.
const SHRINK: f64 = 0.97;

/// The largest distance that n points of the torus can have from each other: that of a triangular lattice, √(2/(√3 n)).
///
/// The packing radius is half of this distance.
pub fn largest_distance(n: usize) -> f64 {
    (2.0 / (3.0_f64.sqrt() * n as f64)).sqrt()
}

// ANCHOR: fill
/// Adds random points (darts) to `points` until there are n. A dart is kept if no other point is nearer than a distance.
///
/// The distance begins with ¾ of the largest possible distance, where hardly any dart finds room, and shrinks by 3 % whenever a
/// hundred darts in a row have missed (Dippé and Wold 1985; the shrinking is by McCool and Fiume, "Hierarchical Poisson disk
/// sampling distributions", 1992).
pub fn fill(points: Vec<Vec2>, n: usize, space: Space, rng: &mut Pcg) -> Vec<Vec2> {
    let mut distance = 0.75 * largest_distance(n);
    let mut near = Neighbours::new(distance, space);
    points.into_iter().take(n).for_each(|p| near.push(p));
    let mut misses = 0;
    while near.points().len() < n {
        let dart = vec2(rng.random(), rng.random());
        if near.has_room(dart, distance) {
            near.push(dart);
            misses = 0;
        } else {
            misses += 1;
        }
        if misses == MISSES {
            distance *= SHRINK;
            misses = 0;
        }
    }
    near.into_points()
}
// ANCHOR_END: fill
