//! Building an octree: cells are cut in eight, as long as cutting pays.
//!
//! ```
//! use raybook::accel::octree::{Octree, build::Limits, reach::by_triangle};
//! use raybook::scene::soup::soup;
//!
//! let bytes = |depth| Octree::with(soup(500, 1).facets(), Limits { depth, ..Limits::USUAL }, by_triangle).bytes();
//! assert!(bytes(1) < bytes(5)); // more cuts take more memory
//! ```

use crate::accel::octree::tree::{Node, Tree, child_cell};
use crate::math::aabb::Aabb;

/// When a cell is not cut any more.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// The cost of opening a node; the unit is the test of one shape.
    pub opening: f32,
    /// Maximum number of leaves that name a shape, on average over the shapes: the bound on memory. Each takes 4 bytes.
    pub copies: f32,
    /// Maximum depth: the number of cuts between the root and a leaf.
    pub depth: u32,
}

impl Limits {
    /// The largest [`Limits::depth`] that a walk can follow: cells down to 1/65,536 of the root's side.
    pub const DEEPEST: u32 = 16;

    /// The largest [`Limits::copies`]: 2 kB per shape. Without a limit, N shapes in the same place take O(N²) of memory, if cutting costs
    /// nothing: 20,000 would take 23 GB.
    pub const MOST_COPIES: f32 = 512.0;

    /// Measured on this course's scenes: a cost of opening from 1 to 3 makes little difference, and up to 8 copies per shape pay.
    pub const USUAL: Self = Self {
        opening: 2.0,
        copies: 8.0,
        depth: Self::DEEPEST,
    };
}

// ANCHOR: octree_build
/// The octree of the shapes 0, 1, … `count` − 1 in the cell `bounds`; `reached` returns which of eight cells a shape reaches, one
/// bit each.
///
/// A leaf of n shapes costs a ray that enters it n tests. If the leaf is cut in eight, the ray pays for opening the node and for
/// the tests in the children that it enters. A child has a quarter of the cell's surface, so one of four rays through the cell
/// goes through the child (the surface-area heuristic: MacDonald and Booth 1990). With nᵢ shapes in child i, cutting pays if
///
/// > opening + ¼ Σ nᵢ < n.
///
/// Cutting never pays where shapes reach four children or more on average: triangles with a common corner in the cell's middle
/// lie in all eight.
pub(crate) fn build(
    bounds: Aabb,
    count: u32,
    limits: Limits,
    reached: &impl Fn(u32, &[Aabb; 8]) -> u8,
) -> Tree {
    /// 128 bytes per shape, and three times as many while the list grows. Only shapes that lie in groups of three, far from all
    /// others, would need more nodes.
    const NODES_PER_SHAPE: usize = 16;
    let most = NODES_PER_SHAPE * count as usize + 4096;
    let mut tree = Tree {
        bounds,
        nodes: vec![Node::leaf(0, 0)],
        named: Vec::new(),
    };
    let mut to_do = vec![(0, bounds, (0..count).collect::<Vec<_>>(), limits)];
    while let Some((node, cell, shapes, limits)) = to_do.pop() {
        let cells: [Aabb; 8] = std::array::from_fn(|i| child_cell(&cell, i));
        let reached: Vec<_> = shapes.iter().map(|&shape| reached(shape, &cells)).collect();
        let (before, after) = (
            shapes.len(),
            reached.iter().map(|bits| bits.count_ones()).sum::<u32>(),
        );
        let copies = after as f32 / before as f32;
        let pays = limits.opening + 0.25 * (after as f32) < before as f32;
        let is_full = tree.nodes.len() + 8 > most;
        if !pays || copies > limits.copies || limits.depth == 0 || is_full {
            tree.nodes[node] = Node::leaf(tree.named.len() as u32, before as u32);
            tree.named.extend(shapes);
            continue;
        }
        let children = tree.nodes.len();
        let occupied = reached.iter().fold(0, |all, bits| all | bits);
        tree.nodes[node] = Node::inner(children as u32, occupied);
        tree.nodes.extend([Node::leaf(0, 0); 8]);
        // The limit on copies, divided by the copies that this cut makes: what is left for the cuts below.
        let limits = Limits {
            depth: limits.depth - 1,
            copies: limits.copies / copies.max(1.0),
            ..limits
        };
        // In reverse, because the last one pushed is cut first: child 0's children are to be the next in the array.
        for i in (0..8).rev().filter(|i| occupied >> i & 1 != 0) {
            let inside = shapes.iter().zip(&reached);
            let inside = inside
                .filter(|(_, bits)| *bits >> i & 1 != 0)
                .map(|(&shape, _)| shape);
            to_do.push((children + i, cells[i], inside.collect(), limits));
        }
    }
    tree
}
// ANCHOR_END: octree_build
