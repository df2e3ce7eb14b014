//! The best of all splits where few items are left.

use crate::accel::bvh::build::cost::Cost;
use crate::accel::bvh::build::item::{Bounds, Item};

/// Number of items of which all splits are tried.
pub(super) const FEW: usize = 32;

/// Reorders at most [`FEW`] items by the best split; returns how many are on the left, and the price of both sides.
///
/// It is the split of [`sah_split`](crate::accel::bvh::build::sweep::sah_split), but for items with equal centres, which keep
/// their order here. Most branches of a tree are at its bottom: so nothing is allocated, and what is sorted are numbers of 64 bits.
pub(crate) fn best(items: &mut [Item], cost: &Cost) -> (usize, f32) {
    let n = items.len();
    let (mut left, mut least) = (n / 2, f32::INFINITY);
    let mut order: [u64; FEW] = std::array::from_fn(|place| place as u64);
    let mut right = [0.0; FEW];
    for axis in 0..3 {
        let mut keys = [0; FEW];
        let keys = &mut keys[..n];
        for (place, (key, item)) in keys.iter_mut().zip(&*items).enumerate() {
            *key = self::key(item.center2_along(axis), place);
        }
        keys.sort_unstable();
        let mut side = Bounds::EMPTY;
        for i in (1..n).rev() {
            side = side.union(&items[place(keys[i])].bounds);
            right[i] = side.half_area() * cost.shapes(n - i);
        }
        side = Bounds::EMPTY;
        let mut better = false;
        for i in 1..n {
            side = side.union(&items[place(keys[i - 1])].bounds);
            let both = side.half_area() * cost.shapes(i) + right[i];
            if both < least {
                (left, least, better) = (i, both, true);
            }
        }
        if better {
            order[..n].copy_from_slice(keys);
        }
    }
    let mut sorted = [items[0]; FEW];
    for (to, &key) in sorted.iter_mut().zip(&order[..n]) {
        *to = items[place(key)];
    }
    items.copy_from_slice(&sorted[..n]);
    (left, least)
}

/// A number by which items are in the order of their centres, and those with equal centres in the order of their places.
fn key(center2: f32, place: usize) -> u64 {
    let bits = center2.to_bits();
    // Of negative floats the largest bits are the least number: all are turned over. Of others, the sign alone.
    let turned = bits ^ if bits >> 31 == 1 { u32::MAX } else { 1 << 31 };
    u64::from(turned) << 32 | place as u64
}

/// The place in a key.
fn place(key: u64) -> usize {
    key as u32 as usize % FEW
}
