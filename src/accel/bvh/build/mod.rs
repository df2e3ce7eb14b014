//! From boxes to a tree: the three stages of building a bounding volume hierarchy.
//!
//! 1. `item`: each shape's box, and its centre. Nothing else of a shape is looked at.
//! 2. `tree`: top-down by the middle, the median or the surface-area heuristic, or bottom-up.
//! 3. `flat`: the tree as a compact array without pointers.
//!
//! ```
//! use raybook::accel::bvh::{Bvh, build::Method};
//!
//! let cost = |method| Bvh::build(raybook::shape::teapot::mesh(3).facets(), method).sah_cost();
//! assert!(cost(Method::Sweep) < cost(Method::Median)); // the heuristic looks at the boxes, the median does not
//! ```

mod binned;
mod bottom_up;
pub(crate) mod cost;
pub(crate) mod fine;
pub(crate) mod flat;
pub(crate) mod halves;
pub(crate) mod item;
pub(crate) mod sweep;
mod top_down;
pub(crate) mod tree;

use crate::accel::bvh::build::{cost::Cost, flat::Flat, item::Item, top_down::top_down};
use crate::math::aabb::Aabb;
use crate::threads;

/// How stage 2 makes a tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Top-down: split at the median, half of the shapes to each side.
    Median,
    /// Top-down: split in the middle of the box of the centres.
    Middle,
    /// Top-down: the best of all splits by the surface-area heuristic (SAH).
    Sweep,
    /// Top-down: the best split between 8 or 16 bins, by the same heuristic.
    Binned,
    /// Top-down: the best split between 32 bins, and the best of all splits where few shapes are left.
    Fine,
    /// Bottom-up: neighbours that have the smallest box together are merged, round after round.
    BottomUp,
}

/// Builds a tree over finite boxes within the [domain](crate::math::domain).
///
/// The same boxes give the same tree, whatever the number of threads.
pub(crate) fn build(boxes: &[Aabb], method: Method, cost: &Cost) -> Flat {
    let mut items = threads::list(boxes.len(), |i| Item::new((i, &boxes[i])));
    let split = match method {
        Method::Median => halves::median,
        Method::Middle => halves::middle,
        Method::Sweep => sweep::split,
        Method::Binned => binned::split,
        Method::Fine => fine::split,
        Method::BottomUp => return bottom_up::build(items, cost),
    };
    let tree = top_down(&mut items, cost, split);
    Flat::new(&tree, items.iter().map(|item| item.index).collect())
}
