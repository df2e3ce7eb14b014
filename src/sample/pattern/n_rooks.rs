//! N-rooks: n rooks on a board of n × n squares, none of which attacks another.
//!
//! ```
//! use raybook::math::pcg;
//! use raybook::sample::pattern::n_rooks::n_rooks;
//!
//! let points = n_rooks(5, &mut pcg::stream(1, 0));
//! let mut rows: Vec<_> = points.iter().map(|p| (5.0 * p.y) as u32).collect();
//! rows.sort();
//! assert_eq!(rows, [0, 1, 2, 3, 4]); // no rook attacks another
//! ```

use crate::math::pcg::Pcg;
use crate::sample::pattern::rows::place;
use glam::{Vec2, vec2};
use rand::RngExt;
use rand::seq::SliceRandom;

// ANCHOR: n_rooks
/// n points, one in each of n columns and one in each of n rows (Shirley, "Discrepancy as a quality measure for sample
/// distributions", 1991; in statistics, Latin hypercube sampling: McKay, Beckman and Conover 1979).
///
/// Along each axis the points are as even as jittered ones; in two dimensions they are hardly better than random points.
pub fn n_rooks(n: usize, rng: &mut Pcg) -> Vec<Vec2> {
    let mut row: Vec<_> = (0..n).collect();
    row.shuffle(rng);
    let mut rook = |(i, j)| vec2(place(i, 1, rng.random(), n), place(j, 1, rng.random(), n));
    row.into_iter().enumerate().map(&mut rook).collect()
}
// ANCHOR_END: n_rooks
