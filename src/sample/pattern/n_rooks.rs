//! N-rooks: as many rooks on a chess board as it has rows, none of which attacks another.

use crate::math::pcg::Pcg;
use crate::sample::pattern::rows::place;
use glam::{Vec2, vec2};
use rand::RngExt;
use rand::seq::SliceRandom;

// ANCHOR: n_rooks
/// n points of which each has one of n columns and one of n rows for itself (Shirley, "Discrepancy as a quality measure for
/// sample distributions", 1991; statisticians call it a Latin hypercube: McKay, Beckman and Conover 1979).
///
/// It is as good as can be along the axes, and hardly better than random across.
pub fn n_rooks(n: usize, rng: &mut Pcg) -> Vec<Vec2> {
    let mut row: Vec<_> = (0..n).collect();
    row.shuffle(rng);
    let mut rook = |(i, j)| vec2(place(i, 1, rng.random(), n), place(j, 1, rng.random(), n));
    row.into_iter().enumerate().map(&mut rook).collect()
}
// ANCHOR_END: n_rooks
