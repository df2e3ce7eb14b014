//! The best of all splits, by the surface-area heuristic.

use crate::accel::bvh::build::cost::Cost;
use crate::accel::bvh::build::item::{Bounds, Item};

/// Splits the items by the best of all cuts between two centres that follow each other along an axis, if that is better
/// than a leaf.
pub fn split(items: &mut [Item], bounds: &Bounds, cost: &Cost) -> Option<usize> {
    let (axis, left, area) = sah_split(items, cost);
    let parent = bounds.half_area();
    if cost.branch * parent + area >= cost.shapes(items.len()) * parent {
        return None;
    }
    sort_along(items, axis);
    Some(left)
}

// ANCHOR: sah_split
/// The axis, the number of items on the left, and the cost of the best split.
///
/// The cost is A(L)·C(|L|) + A(R)·C(|R|), where A is half the area of a side's box and C the price of testing its
/// shapes: a ray that meets the parent's box meets a side's box with the probability A(side)/A(parent)
/// (Goldsmith and Salmon 1987, MacDonald and Booth 1990).
pub fn sah_split(items: &mut [Item], cost: &Cost) -> (usize, usize, f32) {
    let mut best = (0, items.len() / 2, f32::INFINITY);
    let mut right = vec![0.0; items.len()];
    for axis in 0..3 {
        sort_along(items, axis);
        let mut bounds = Bounds::EMPTY;
        for (i, item) in items.iter().enumerate().rev() {
            bounds = bounds.union(&item.bounds);
            right[i] = bounds.half_area() * cost.shapes(items.len() - i);
        }
        bounds = Bounds::EMPTY;
        for (i, item) in items.iter().enumerate() {
            let total = bounds.half_area() * cost.shapes(i) + right[i];
            if i > 0 && total < best.2 {
                best = (axis, i, total);
            }
            bounds = bounds.union(&item.bounds);
        }
    }
    best
}
// ANCHOR_END: sah_split

/// Sorts by the centres along an axis, equal ones by their numbers.
fn sort_along(items: &mut [Item], axis: usize) {
    items.sort_unstable_by(|a, b| {
        let by_center = a.center2()[axis].total_cmp(&b.center2()[axis]);
        by_center.then(a.index.cmp(&b.index))
    });
}
