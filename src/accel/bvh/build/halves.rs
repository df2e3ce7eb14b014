//! Splits without a heuristic: at the median, or in the middle.

use crate::accel::bvh::build::cost::Cost;
use crate::accel::bvh::build::item::{Extent, Item};

/// Whether to split further: yes while there are more items than half of what a leaf may hold.
fn too_many(items: &[Item], cost: &Cost) -> bool {
    2 * items.len() > cost.most as usize
}

/// Splits the items at the median, half to each side, along the axis on which the centres are spread most.
pub(super) fn median(items: &mut [Item], extent: &Extent, cost: &Cost) -> Option<usize> {
    too_many(items, cost).then(|| halve(items, extent))
}

/// Splits the items where the box of their centres has its middle, along its longest axis.
pub(super) fn middle(items: &mut [Item], extent: &Extent, cost: &Cost) -> Option<usize> {
    let (axis, centers2) = (extent.widest(), &extent.centers2);
    let middle2 = 0.5 * (centers2.min[axis] + centers2.max[axis]);
    too_many(items, cost).then(|| partition(items, |item| item.center2_along(axis) < middle2))
}

/// Reorders the items so that the first half has the smaller centres along the widest axis; returns the size of that half.
/// Equal centres may be in either half.
pub(crate) fn halve(items: &mut [Item], extent: &Extent) -> usize {
    let (axis, half) = (extent.widest(), items.len() / 2);
    items.select_nth_unstable_by(half, |a, b| {
        a.center2_along(axis).total_cmp(&b.center2_along(axis))
    });
    half
}

/// Moves the items for which `left` holds to the front; returns how many these are.
pub(super) fn partition(items: &mut [Item], left: impl Fn(&Item) -> bool) -> usize {
    let (mut at, mut end) = (0, items.len());
    while at < end {
        if left(&items[at]) {
            at += 1;
        } else {
            end -= 1;
            items.swap(at, end);
        }
    }
    at
}
