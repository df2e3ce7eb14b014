//! Cutting cells in eight, as long as it pays.

use crate::accel::octree::tree::{Node, Tree, child_cell};
use crate::math::aabb::Aabb;

/// The cost of opening a node, in tests of shapes. Measured: see the chapter's page.
const OPENING: f32 = 1.0;

/// When cutting ends, whether it pays or not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// The root is cut at most so often.
    pub depth: u32,
    /// The leaves name each shape at most so often, on average: the bound on memory.
    pub copies: f32,
}

impl Limits {
    /// Cells down to a millionth of the root; lists of eight times as many numbers as there are shapes.
    pub const USUAL: Self = Self {
        depth: 20,
        copies: 8.0,
    };
}

// ANCHOR: octree_build
/// The tree of the shapes 0, 1, … count − 1 in a cell; `overlaps` says whether a shape has a point in a cell.
///
/// A leaf of n shapes costs a ray that enters it n tests. Cut in eight, it costs the opening of the node, and the tests in
/// the children that the ray enters. A child has a quarter of the cell's surface, so one of four rays through the cell goes
/// through it (the surface-area heuristic: MacDonald and Booth 1990). With nᵢ shapes in child i, cutting pays if
///
/// > opening + ¼ Σ nᵢ < n.
///
/// It never does where most shapes lie in four children or more: a corner that they share, a triangle as large as the cell.
pub fn build(
    bounds: Aabb,
    count: u32,
    limits: Limits,
    overlaps: &impl Fn(u32, &Aabb) -> bool,
) -> Tree {
    let mut tree = Tree {
        bounds,
        nodes: vec![Node::leaf(0, 0)],
        named: Vec::new(),
    };
    let mut to_do = vec![(0, bounds, (0..count).collect::<Vec<_>>(), limits)];
    while let Some((node, cell, shapes, limits)) = to_do.pop() {
        let cells: [Aabb; 8] = std::array::from_fn(|i| child_cell(&cell, i));
        let parts = cells.map(|cell| {
            let inside = shapes.iter().filter(|&&shape| overlaps(shape, &cell));
            inside.copied().collect::<Vec<_>>()
        });
        let (before, after) = (shapes.len(), parts.iter().map(Vec::len).sum::<usize>());
        let copies = after as f32 / before as f32;
        let pays = OPENING + 0.25 * (after as f32) < before as f32;
        if !pays || copies > limits.copies || limits.depth == 0 {
            tree.nodes[node] = Node::leaf(tree.named.len() as u32, shapes.len() as u32);
            tree.named.extend(shapes);
            continue;
        }
        let children = tree.nodes.len();
        let occupied = (0..8).fold(0, |bits, i| bits | u8::from(!parts[i].is_empty()) << i);
        tree.nodes[node] = Node::inner(children as u32, occupied);
        tree.nodes.extend([Node::leaf(0, 0); 8]);
        // What is left of the limit on copies: the shapes inside may still be named so often.
        let limits = Limits {
            depth: limits.depth - 1,
            copies: limits.copies / copies.max(1.0),
        };
        // The last is done first: child 0's children are to follow soon.
        for (i, part) in parts.into_iter().enumerate().rev() {
            if !part.is_empty() {
                to_do.push((children + i, cells[i], part, limits));
            }
        }
    }
    tree
}
// ANCHOR_END: octree_build
