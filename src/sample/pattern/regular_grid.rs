//! The regular grid: a point in the middle of every cell.
//!
//! ```
//! use glam::vec2;
//! use raybook::sample::pattern::regular_grid::regular_grid;
//!
//! assert_eq!(regular_grid(2, 1), [vec2(0.25, 0.5), vec2(0.75, 0.5)]);
//! ```

use crate::sample::pattern::rows::place;
use glam::{Vec2, vec2};

// ANCHOR: regular_grid
/// The middles of columns × rows equal cells of the unit square: ((i + ½)/columns, (j + ½)/rows).
///
/// A vertical edge shows only `columns` + 1 levels of grey, and stripes that are finer than the cells look like broad stripes
/// (aliasing).
pub fn regular_grid(columns: usize, rows: usize) -> Vec<Vec2> {
    let cells = (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j)));
    let middle = |(i, j)| vec2(place(i, 1, 0.5, columns), place(j, 1, 0.5, rows));
    cells.map(middle).collect()
}
// ANCHOR_END: regular_grid
