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
    let orders = [0, 1, 2].map(|along| order_along(items, along));
    for (along, order) in orders.iter().enumerate() {
        let mut side = Bounds::EMPTY;
        for (i, key) in (1..n).zip(order.iter().skip(1)).rev() {
            side = side.union(&key.of(items).bounds);
            right[i] = side.half_area() * cost.shapes(n - i);
        }
        side = Bounds::EMPTY;
        for (i, key) in (1..n).zip(order) {
            side = side.union(&key.of(items).bounds);
            let both = side.half_area() * cost.shapes(i) + right[i];
            if both < least {
                (axis, left, least) = (along, i, both);
            }
        }
    }
    let ordered: Vec<Item> = orders[axis].iter().map(|key| *key.of(items)).collect();
    items.copy_from_slice(&ordered);
    (left, least)
}
// ANCHOR_END: sah_split

/// An item's rank along an axis, and its place in the list: 16 bytes to sort, and one comparison, where an item is 48 and two.
///
/// From the highest bit: the centre, as a number of 32 bits that is ordered as the floats are; the item's own number, so that
/// items with equal centres have an order; and its place.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Key(u128);

impl Key {
    fn new(at: usize, item: &Item, axis: usize) -> Self {
        let bits = item.center2_along(axis).to_bits();
        // Of negative floats the largest bits are the least number: all are turned over. Of others, the sign alone.
        let turned = bits ^ if bits >> 31 == 1 { u32::MAX } else { 1 << 31 };
        Self(u128::from(turned) << 64 | u128::from(item.index) << 32 | at as u128)
    }

    fn of(self, items: &[Item]) -> &Item {
        &items[self.0 as u32 as usize]
    }
}

/// The items by their centres along an axis, and those with equal centres by their numbers.
fn order_along(items: &[Item], axis: usize) -> Vec<Key> {
    let keys = items.iter().enumerate();
    let mut keys: Vec<_> = keys.map(|(at, item)| Key::new(at, item, axis)).collect();
    keys.sort_unstable();
    keys
}
