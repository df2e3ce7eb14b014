//! The best of all splits, by the surface-area heuristic.

use crate::accel::bvh::build::cost::Cost;
use crate::accel::bvh::build::item::{Bounds, Extent, Item};

/// Splits the items where the cost is least, and returns how many are on the left; `None` if a leaf costs no more.
pub(crate) fn split(items: &mut [Item], extent: &Extent, cost: &Cost) -> Option<usize> {
    let (left, both) = sah_split(items, cost);
    let parent = extent.bounds.half_area();
    let better = cost.branch * parent + both < cost.shapes(items.len()) * parent;
    better.then_some(left)
}

// ANCHOR: sah_split
/// Reorders the items by the best split; returns how many are on the left, and the cost of the split.
///
/// A split is a cut between two neighbouring centres along an axis. Its cost is A(L)·c(L) + A(R)·c(R). A is half the surface
/// area of a side's box, in m²: the number of rays that meet the box is proportional to A. c is the price of testing all
/// shapes of the side, [`Cost::shapes`] (Goldsmith and Salmon 1987; MacDonald and Booth 1990).
pub fn sah_split(items: &mut [Item], cost: &Cost) -> (usize, f32) {
    let n = items.len();
    let (mut axis, mut left, mut least) = (0, n / 2, f32::INFINITY);
    let mut right = vec![0.0; n];
    for along in 0..3 {
        sort_along(items, along);
        let mut side = Bounds::EMPTY;
        for i in (1..n).rev() {
            side = side.union(&items[i].bounds);
            right[i] = side.half_area() * cost.shapes(n - i);
        }
        side = Bounds::EMPTY;
        for i in 1..n {
            side = side.union(&items[i - 1].bounds);
            let both = side.half_area() * cost.shapes(i) + right[i];
            if both < least {
                (axis, left, least) = (along, i, both);
            }
        }
    }
    sort_along(items, axis);
    (left, least)
}
// ANCHOR_END: sah_split

/// Sorts the items by their centres along an axis, and those with equal centres by their numbers.
fn sort_along(items: &mut [Item], axis: usize) {
    items.sort_unstable_by(|a, b| {
        let by_center = a.center2_along(axis).total_cmp(&b.center2_along(axis));
        by_center.then(a.index.cmp(&b.index))
    });
}
