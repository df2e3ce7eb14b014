//! Stage 2, top-down: split the shapes in two, and each half again.

use crate::accel::bvh::build::cost::Cost;
use crate::accel::bvh::build::halves::halve;
use crate::accel::bvh::build::item::{Extent, Item};
use crate::accel::bvh::build::tree::{Inside, MAX_DEPTH, Tree, halvings};
use crate::threads;

/// A way to split at least two items: reorders them and returns how many are on the left, or `None` if a leaf is better.
pub(super) type Split = fn(&mut [Item], &Extent, &Cost) -> Option<usize>;

/// Below this number of items, another thread does not pay.
const ALONE: usize = 1 << 12;

/// Builds a tree over the items, and puts the items into the order of its leaves.
pub(super) fn top_down(items: &mut [Item], cost: &Cost, split: Split) -> Tree {
    bvh_build(items, MAX_DEPTH, cost, split)
}

// ANCHOR: bvh_build
/// Builds the subtree over the items, with at most `levels` branches above any leaf.
///
/// `split` reorders the items into a left and a right side, or says that a leaf is better. It is overruled by a split at the
/// median in two cases: the leaf would be too large, or a side would have too many items to be halved in the levels that are
/// left.
fn bvh_build(items: &mut [Item], levels: u32, cost: &Cost, split: Split) -> Tree {
    let (n, extent) = (items.len(), Extent::of(items));
    let bounds = extent.bounds;
    let fits = |&left: &usize| (1..n).contains(&left) && halvings(left.max(n - left)) < levels;
    let at = match (n > 1).then(|| split(items, &extent, cost)).flatten() {
        None if n <= cost.most as usize => {
            let inside = Inside::Leaf(n as u32);
            return Tree { bounds, inside };
        }
        at => at.filter(fits).unwrap_or_else(|| halve(items, &extent)),
    };
    let (left, right) = items.split_at_mut(at);
    let subtree = |items: &mut [Item]| bvh_build(items, levels - 1, cost, split);
    let (left, right) = if n < ALONE {
        (subtree(left), subtree(right))
    } else {
        threads::join(|| subtree(left), || subtree(right))
    };
    let inside = Inside::Branch(Box::new([left, right]));
    Tree { bounds, inside }
}
// ANCHOR_END: bvh_build
