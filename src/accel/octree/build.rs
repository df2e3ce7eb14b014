//! Cutting cells in eight, as long as it pays.

use crate::accel::octree::tree::{Node, Tree, child_cell};
use crate::math::aabb::Aabb;

/// When cutting ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// The cost of opening a node, in tests of shapes.
    pub opening: f32,
    /// Maximum number of leaves that name a shape, on average: the bound on memory.
    pub copies: f32,
    /// Maximum depth: the number of cuts between the root and a leaf.
    pub depth: u32,
}

impl Limits {
    /// The most [`Limits::depth`] that a walk can follow: cells down to a 65,536th of the root.
    pub const DEEPEST: u32 = 16;

    /// Measured, see the chapter's page: from 1 to 3, the cost of opening hardly matters; up to 8, copies pay.
    pub const USUAL: Self = Self {
        opening: 2.0,
        copies: 8.0,
        depth: Self::DEEPEST,
    };
}

// ANCHOR: octree_build
/// The tree of the shapes 0, 1, … count − 1 in a cell; `reached` says which of eight cells a shape reaches, one bit each.
///
/// A leaf of n shapes costs a ray that enters it n tests. Cut in eight, it costs the opening of the node, and the tests in
/// the children that the ray enters. A child has a quarter of the cell's surface, so of four rays through the cell one goes
/// through the child (the surface-area heuristic: MacDonald and Booth 1990). With nᵢ shapes in child i, cutting pays if
///
/// > opening + ¼ Σ nᵢ < n.
///
/// It never does where most shapes reach four children or more: a corner that they share, a triangle as large as the cell.
pub(crate) fn build(
    bounds: Aabb,
    count: u32,
    limits: Limits,
    reached: &impl Fn(u32, &[Aabb; 8]) -> u8,
) -> Tree {
    /// 128 bytes, and three times as many while the list grows. Only shapes that lie in threes, far from all others, would ever take more.
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
        // What is left of the limit on copies: the shapes in the children may still be named so often.
        let limits = Limits {
            depth: limits.depth - 1,
            copies: limits.copies / copies.max(1.0),
            ..limits
        };
        // The last is done first: child 0's children shall be the next in the array.
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
