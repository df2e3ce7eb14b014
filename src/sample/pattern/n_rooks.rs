//! N-rooks: n rooks on a board of n × n squares, none of which attacks another.

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
