//! What a search costs: the surface-area heuristic.

use crate::accel::bvh::build::flat::Node;
use crate::accel::bvh::pair::Pair;

/// The prices of a ray's steps through a tree, in any unit: only their ratio matters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cost {
    /// The price of testing the boxes of a branch's children.
    pub branch: f32,
    /// The price of testing a block of shapes.
    pub block: f32,
    /// Number of shapes in a block, which are tested at once: a power of two.
    pub block_size: u32,
    /// Maximum number of shapes in a leaf.
    pub most: u32,
}

impl Cost {
    /// The price of testing `count` shapes: ⌈`count`/`block_size`⌉ · `block`.
    pub fn shapes(&self, count: usize) -> f32 {
        let last = self.block_size as usize - 1;
        self.block * ((count + last) >> last.count_ones()) as f32
    }
}

// ANCHOR: sah_cost
/// The expected price of a search by a random ray that crosses the root's box: the surface-area heuristic (SAH; MacDonald and
/// Booth 1990). 0 for a tree without a root.
///
/// A random line that meets a convex body meets a convex body inside it with a probability that is the ratio of their surface
/// areas A. So the price is Σ A(n)/A(root)·c(n) over all nodes n: c is [`Cost::branch`] for a branch, and for a leaf the
/// price of its shapes.
pub fn sah_cost(root: Option<&Node>, pairs: &[Pair], cost: &Cost) -> f32 {
    let price = |node: &Node| {
        let size = node.bounds.size();
        let area = 2.0 * (size.x * size.y + size.y * size.z + size.z * size.x);
        let price = match node.link.count {
            0 => cost.branch,
            count => cost.shapes(count as usize),
        };
        (area, f64::from(area) * f64::from(price))
    };
    let Some((whole, all)) = root.map(price) else {
        return 0.0;
    };
    let below = pairs
        .iter()
        .flat_map(Pair::nodes)
        .map(|node| price(&node).1);
    ((all + below.sum::<f64>()) / f64::from(whole.max(f32::MIN_POSITIVE))) as f32
}
// ANCHOR_END: sah_cost
