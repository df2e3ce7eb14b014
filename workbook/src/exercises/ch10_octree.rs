//! Chapter 10: `octree_child`, `octree_build`, `octree_walk`.

use crate::exercise::exercises;
use crate::exercises::ch05_box::Corners;
use crate::octree_rows::{NodeRow, TreeRow, to_tree};
use glam::Vec3;
use raybook::accel::octree::build::Limits;
use raybook::inside::octree::{Tree, Walk, build, child_at};
use raybook::math::{aabb::Aabb, interval::Interval, ray::Ray};

exercises! { ($) ch10_octree
    /// Return the number of the child in which a point of a cell lies: 4·z + 2·y + x, where x is 1 in the upper half
    /// along x and 0 in the lower half, and y and z likewise. The middle plane belongs to the upper half. The sides of
    /// the cell may have different lengths.
    OctreeChild: octree_child(
        /// The cell's least corner, in metres.
        min: Vec3,
        /// The cell's greatest corner, in metres.
        max: Vec3,
        /// The point, in metres.
        p: Vec3,
    ) -> (
        /// The number of the child, from 0 to 7.
        child: u32,
    ) {
        child_at(&Aabb::new(min, max), p) as u32
    }

    /// Build the octree of the shapes: cut a cell in eight if that lowers the expected cost, if opening + ¼ Σ nᵢ < n,
    /// with n shapes in the cell and nᵢ in child i. Stop where the limits allow no more depth or no more copies. A shape
    /// is listed in every leaf that its box reaches.
    ///
    /// In Rust: `reached(shape, &cells)` has bit i set if the shape with this number, from 0 up to `count`, reaches cell
    /// i of eight; `child_cell` gives the eight. `Node::leaf` and `Node::inner` make the nodes.
    OctreeBuild: octree_build(
        /// The root's least corner, in metres.
        min: Vec3,
        /// The root's greatest corner, in metres.
        max: Vec3,
        /// The cost of opening a node, where testing one shape costs 1.
        opening: f32,
        /// The maximum number of leaves that name a shape, on average over all shapes.
        copies: f32,
        /// The maximum number of cuts between the root and a leaf.
        depth: u32,
        /// The shapes' boxes; their numbers count from 0.
        shapes: Vec<Corners>,
    ) -> (
        /// The tree.
        answer: TreeRow,
    ) {
        let bounds = Aabb::new(min, max);
        let limits = Limits {
            opening,
            copies,
            depth: depth.min(Limits::DEEPEST),
        };
        let tree = build(bounds, shapes.len() as u32, limits, &|i, cells| {
            reached(&shapes[i as usize], cells)
        });
        TreeRow::from(tree)
    }

    /// List the leaves that are not empty and that the ray passes through within the interval, front to back.
    ///
    /// In Rust: each call returns the next of them that the ray enters before `limit`, or None; `count` the nodes that
    /// the ray enters.
    OctreeWalk: octree_walk(
        /// The ray.
        ray: Ray,
        /// The distances that count, in metres.
        within: Interval,
        /// The root's least corner, in metres.
        min: Vec3,
        /// The root's greatest corner, in metres.
        max: Vec3,
        /// The nodes: the root first, the eight children of a node side by side, after the node itself.
        nodes: Vec<NodeRow>,
    ) -> (
        /// The leaves on the ray's way, by their numbers in the list of nodes, from 0, in order; empty leaves are
        /// left out.
        leaf: Vec<u32>,
    ) |q| {
        let tree = q.tree();
        let mut walk = Walk::new(&tree, &q.ray, q.within);
        std::iter::from_fn(|| walk.next_leaf(q.within.max, &mut ())).collect()
    }
}

/// Which of eight cells a box reaches or touches, one bit each.
pub fn reached(shape: &Corners, cells: &[Aabb; 8]) -> u8 {
    let reaches = |cell: &Aabb| shape.min.cmple(cell.max).all() && cell.min.cmple(shape.max).all();
    (0..8).fold(0, |bits, i| bits | u8::from(reaches(&cells[i])) << i)
}

impl OctreeWalk {
    /// The tree, as the library stores it.
    pub fn tree(&self) -> Tree {
        to_tree(Aabb::new(self.min, self.max), &self.nodes)
    }
}
