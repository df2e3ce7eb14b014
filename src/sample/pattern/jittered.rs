//! Jittered (stratified) points: a random point in each cell of a grid.
//!
//! ```
//! use raybook::math::pcg;
//! use raybook::sample::pattern::jittered::jittered;
//!
//! let points = jittered(4, 4, &mut pcg::stream(1, 0));
//! let in_cell = |p: &&glam::Vec2| p.x < 0.25 && p.y < 0.25;
//! assert_eq!((points.len(), points.iter().filter(in_cell).count()), (16, 1));
//! ```

use crate::math::pcg::Pcg;
use crate::sample::pattern::rows::place;
use glam::{Vec2, vec2};
use rand::RngExt;

// ANCHOR: jittered
/// A random point in each of columns × rows equal cells of the unit square: ((i + u)/columns, (j + v)/rows) (Cook, Porter and
/// Carpenter, "Distributed ray tracing", 1984).
///
/// Two points can still be close to each other, on both sides of a cell's edge.
pub fn jittered(columns: usize, rows: usize, rng: &mut Pcg) -> Vec<Vec2> {
    let cells = (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j)));
    let mut anywhere = |(i, j)| {
        let (u, v) = (rng.random(), rng.random());
        vec2(place(i, 1, u, columns), place(j, 1, v, rows))
    };
    cells.map(&mut anywhere).collect()
}
// ANCHOR_END: jittered
