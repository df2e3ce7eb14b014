//! Chapter 10: `octree_child`, `octree_build`, `octree_walk`.

use raybook::accel::octree::build::Limits;
use raybook::inside::octree::{Tree, Walk, build, child_at};
use raybook::math::{aabb::Aabb, interval::Interval, ray::Ray};
use crate::exercise::{Asked, Exercise};
use crate::exercises::ch05_box::Corners;
use crate::octree_rows::{NodeRow, TreeRow, to_tree};
use crate::row::row;
use glam::Vec3;

/// This chapter's exercises, in order.
pub const EXERCISES: &[&dyn Asked] = &[&OctreeChild, &OctreeBuild, &OctreeWalk];

/// See [`Exercise::TASK`].
pub struct OctreeChild;

row! {
    /// A cell and a point in it.
    pub struct OctreeChildQuestion {
        /// The cell's least corner.
        pub min: Vec3,
        /// Its greatest corner.
        pub max: Vec3,
        /// The point.
        pub p: Vec3,
    }
}

impl Exercise for OctreeChild {
    type Question = OctreeChildQuestion;
    type Answer = u32;
    const NAME: &'static str = "octree_child";
    const ANSWER: &'static str = "child";
    const TASK: &'static str = "Return the number of the child in which a point of a cell lies, 4·z + 2·y + x, where x is 1 in the upper half along x, from the middle plane on, and 0 in the lower half, and so on.";

    fn answer(q: &Self::Question) -> Self::Answer {
        child_at(&Aabb::new(q.min, q.max), q.p) as u32
    }
}

/// See [`Exercise::TASK`].
pub struct OctreeBuild;

row! {
    /// A cell, when cutting ends, and the boxes of the shapes.
    pub struct OctreeBuildQuestion {
        /// The root's least corner.
        pub min: Vec3,
        /// Its greatest corner.
        pub max: Vec3,
        /// The cost of opening a node, in tests of shapes.
        pub opening: f32,
        /// The leaves may name each shape so often, on average.
        pub copies: f32,
        /// The root may be cut so often.
        pub depth: u32,
        /// The shapes' boxes.
        pub shapes: Vec<Corners>,
    }
}

/// Which of eight cells a box reaches or touches, one bit each.
pub fn reached(shape: &Corners, cells: &[Aabb; 8]) -> u8 {
    let reaches = |cell: &Aabb| shape.min.cmple(cell.max).all() && cell.min.cmple(shape.max).all();
    (0..8).fold(0, |bits, i| bits | u8::from(reaches(&cells[i])) << i)
}

impl Exercise for OctreeBuild {
    type Question = OctreeBuildQuestion;
    type Answer = TreeRow;
    const NAME: &'static str = "octree_build";
    const TASK: &'static str = "Build the octree of shapes: cut a cell in eight if that lowers the expected cost, opening + ¼ Σ nᵢ < n, as long as the depth \
        and the copies that the limits allow last; a shape is named in every leaf that it reaches.";

    fn answer(q: &Self::Question) -> Self::Answer {
        let bounds = Aabb::new(q.min, q.max);
        let limits = Limits {
            opening: q.opening,
            copies: q.copies,
            depth: q.depth.min(Limits::DEEPEST),
        };
        let tree = build(bounds, q.shapes.len() as u32, limits, &|i, cells| {
            reached(&q.shapes[i as usize], cells)
        });
        TreeRow::from(tree)
    }
}

/// See [`Exercise::TASK`].
pub struct OctreeWalk;

row! {
    /// A ray and a tree.
    pub struct OctreeWalkQuestion {
        /// The ray.
        pub ray: Ray,
        /// Only this stretch of the ray counts.
        pub within: Interval,
        /// The root's least corner.
        pub min: Vec3,
        /// Its greatest corner.
        pub max: Vec3,
        /// The nodes, the root first, the eight children of a node side by side, each node's after itself.
        pub nodes: Vec<NodeRow>,
    }
}

impl OctreeWalkQuestion {
    /// The tree, as the library stores it.
    pub fn tree(&self) -> Tree {
        to_tree(Aabb::new(self.min, self.max), &self.nodes)
    }
}

impl Exercise for OctreeWalk {
    type Question = OctreeWalkQuestion;
    type Answer = Vec<u32>;
    const NAME: &'static str = "octree_walk";
    const ANSWER: &'static str = "leaf";
    const TASK: &'static str = "Return the next leaf that is not empty and that the ray enters before `limit`, front to back, or None; `count` the nodes that the ray enters.";

    fn answer(q: &Self::Question) -> Self::Answer {
        let tree = q.tree();
        let mut walk = Walk::new(&tree, &q.ray, q.within);
        std::iter::from_fn(|| walk.next_leaf(q.within.max, &mut ())).collect()
    }
}
