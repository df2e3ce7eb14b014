//! Stage 2, top-down: split the shapes in two, and each half again.

use crate::accel::bvh::build::cost::Cost;
use crate::accel::bvh::build::halves;
use crate::accel::bvh::build::item::{Bounds, Item};
use crate::accel::bvh::build::tree::{Inside, MAX_DEPTH, Tree, halvings};

/// A way to split: reorders the items and says how many are on the left, or `None` if a leaf is better.
///
/// It is given at least two items and the box around them.
pub type Split = fn(&mut [Item], &Bounds, &Cost) -> Option<usize>;

/// Fewer items than this are not worth another thread.
const ALONE: usize = 1 << 12;

/// Builds a tree over the items; reorders them as they follow each other in its leaves.
pub fn top_down(items: &mut [Item], cost: &Cost, split: Split) -> Tree {
    let bounds = Bounds::of(items);
    bvh_build(items, bounds, MAX_DEPTH, cost, split)
}

// ANCHOR: bvh_build
/// Builds the subtree over the items, which `bounds` holds, with at most `levels` branches above any leaf.
///
/// `split` reorders the items into a left and a right side, or says that a leaf is better. It is overruled where a leaf
/// would be too large, and where a side would be too large to be halved in the levels that are left.
fn bvh_build(items: &mut [Item], bounds: Bounds, levels: u32, cost: &Cost, split: Split) -> Tree {
    let n = items.len();
    let fits = |&left: &usize| (1..n).contains(&left) && halvings(left.max(n - left)) < levels;
    let at = match (n > 1).then(|| split(items, &bounds, cost)).flatten() {
        None if n <= cost.most as usize => {
            return Tree {
                bounds,
                inside: Inside::Leaf(n as u32),
            };
        }
        at => at.filter(fits).unwrap_or_else(|| halves::halve(items)),
    };
    let (left, right) = items.split_at_mut(at);
    let subtree = |items: &mut [Item]| {
        let bounds = Bounds::of(items);
        bvh_build(items, bounds, levels - 1, cost, split)
    };
    let (left, right) = if n < ALONE {
        (subtree(left), subtree(right))
    } else {
        rayon::join(|| subtree(left), || subtree(right))
    };
    Tree {
        bounds,
        inside: Inside::Branch(Box::new([left, right])),
    }
}
// ANCHOR_END: bvh_build
