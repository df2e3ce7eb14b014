//! What a tree of boxes costs by the surface-area heuristic (SAH), whoever built it.

use raybook::math::aabb::Aabb;

/// A node of a tree: its box, and what is in it.
pub type Node = (Aabb, Inside);

/// What is tested where a ray meets a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Inside {
    /// The boxes of this number of children.
    Children(usize),
    /// This number of triangles: the node is a leaf.
    Triangles(usize),
}

/// Number of triangles that are tested at once, and count as one block: Embree's, and half of a leaf of `WideBvh`.
const BLOCK: usize = 4;

/// What a random line that crosses the root's box tests on average, if nothing stops it: Σ A(n)/A(root)·c(n) over all nodes n.
///
/// A is the surface area of a box: of the lines that cross a convex body, a part that is the ratio of their areas crosses a
/// convex body inside it (Goldsmith and Salmon 1987; MacDonald and Booth 1990).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sah {
    /// Nodes with children, whatever their number: c = 1.
    pub nodes: f64,
    /// Boxes: c is the number of children.
    pub boxes: f64,
    /// Leaves: c = 1.
    pub leaves: f64,
    /// Blocks of triangles: c = ⌈triangles/4⌉.
    pub blocks: f64,
    /// Triangles: c is their number.
    pub triangles: f64,
}

impl Sah {
    /// The sums over the nodes of a tree, the root among them, in any order; `None` for a root without a surface and for no nodes.
    #[must_use]
    pub fn of(root: &Aabb, nodes: &[Node]) -> Option<Self> {
        let whole = half_area(root);
        if nodes.is_empty() || whole <= 0.0 {
            return None;
        }
        let mut sum = Self::default();
        for (bounds, inside) in nodes {
            let part = half_area(bounds) / whole;
            match *inside {
                Inside::Children(count) => {
                    sum.nodes += part;
                    sum.boxes += part * count as f64;
                }
                Inside::Triangles(count) => {
                    sum.leaves += part;
                    sum.blocks += part * count.div_ceil(BLOCK) as f64;
                    sum.triangles += part * count as f64;
                }
            }
        }
        Some(sum)
    }

    /// One number, with the prices of Embree's builder: a node costs as much as a block of triangles.
    pub fn cost(&self) -> f64 {
        self.nodes + self.blocks
    }
}

/// Half the surface area of a box, in square metres.
fn half_area(bounds: &Aabb) -> f64 {
    let [x, y, z] = bounds.size().to_array().map(f64::from);
    x * y + y * z + z * x
}
