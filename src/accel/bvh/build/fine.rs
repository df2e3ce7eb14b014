//! Between bins as long as there are many items, and the best of all cuts where few are left.

use crate::accel::bvh::build::binned::Cut;
use crate::accel::bvh::build::cost::Cost;
use crate::accel::bvh::build::item::{Extent, Item};
use crate::accel::bvh::build::sweep;

/// So few items are split by trying all cuts.
///
/// Most splits of a tree are at its bottom, where bins are too coarse: a leaf of eight is then filled with six or seven.
const FEW: usize = 32;

/// Splits the items where the surface-area heuristic is least, as well as sweeping does and in a quarter of its time.
pub(super) fn split(items: &mut [Item], extent: &Extent, cost: &Cost) -> Option<usize> {
    if items.len() <= FEW {
        sweep::split(items, extent, cost)
    } else {
        Cut::best::<32>(items, extent, cost).split(items, extent, cost)
    }
}

/// Reorders the items by the cut that [`split`] takes; returns how many are on the left, and the price of both sides.
pub(crate) fn best(items: &mut [Item], extent: &Extent, cost: &Cost) -> (usize, f32) {
    if items.len() <= FEW {
        sweep::sah_split(items, cost)
    } else {
        let cut = Cut::best::<32>(items, extent, cost);
        (cut.apply(items), cut.cost)
    }
}
