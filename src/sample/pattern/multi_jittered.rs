//! Multi-jittered points: jittered and n-rooks at once.
//!
//! ```
//! use raybook::math::pcg;
//! use raybook::sample::pattern::multi_jittered::multi_jittered;
//!
//! let points = multi_jittered(3, 2, &mut pcg::stream(1, 0));
//! let mut columns: Vec<_> = points.iter().map(|p| (6.0 * p.x) as u32).collect();
//! columns.sort();
//! assert_eq!(columns, [0, 1, 2, 3, 4, 5]); // each of six narrow columns has one point
//! ```

use crate::math::pcg::Pcg;
use crate::sample::pattern::rows::place;
use glam::{Vec2, vec2};
use rand::RngExt;
use rand::seq::SliceRandom;

// ANCHOR: multi_jittered
/// A random point in each of columns × rows equal cells, such that each of n = columns · rows narrow columns, and each of n low
/// rows, has exactly one point (Chiu, Shirley and Wang, "Multi-jittered sampling", 1994).
///
/// The narrow columns of a column of cells are assigned to its cells at random; so are the low rows of a row of cells.
pub fn multi_jittered(columns: usize, rows: usize, rng: &mut Pcg) -> Vec<Vec2> {
    let n = columns * rows;
    let mut shares = |groups: usize, of: usize| -> Vec<Vec<usize>> {
        let mut share: Vec<_> = (0..of).collect();
        let shuffled = (0..groups).map(|_| {
            share.shuffle(rng);
            share.clone()
        });
        shuffled.collect()
    };
    let (x, y) = (shares(columns, rows), shares(rows, columns));
    let cells = (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j)));
    let mut anywhere = |(i, j): (usize, usize)| {
        vec2(
            place(rows * i + x[i][j], 1, rng.random(), n),
            place(columns * j + y[j][i], 1, rng.random(), n),
        )
    };
    cells.map(&mut anywhere).collect()
}
// ANCHOR_END: multi_jittered

/// The number of columns for n points: the largest divisor of n up to √n, so that the cells are nearly square; 1 for 0.
pub fn columns(n: usize) -> usize {
    let most = n.isqrt();
    (1..=most).rev().find(|c| n.is_multiple_of(*c)).unwrap_or(1)
}
