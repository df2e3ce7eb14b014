//! Chapter 10: `octree_child`, `octree_build`, `octree_walk`.

use crate::accel::octree::build::{Limits, build};
use crate::accel::octree::tree::{Kind, Node, Tree, child_at};
use crate::accel::octree::walk::Walk;
use crate::math::{aabb::Aabb, interval::Interval, ray::Ray};
use crate::workbook::exercise::{Asked, Exercise};
use crate::workbook::exercises::ch05_box::Corners;
use crate::workbook::row::row;
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

row! {
    /// A node of a tree.
    pub struct NodeRow {
        /// 1 for a node with eight children, 0 for a leaf.
        pub inner: u32,
        /// The number of its first child; or the place in the list of names where the leaf's names begin.
        pub first: u32,
        /// How many shapes a leaf names; 0 for a node with children.
        pub count: u32,
    }
}

row! {
    /// A tree: its nodes, the root first, the eight children of a node side by side; and the names in its leaves.
    pub struct TreeRow {
        /// The nodes.
        pub nodes: Vec<NodeRow>,
        /// The shapes that the leaves name, by their numbers from 0.
        pub names: Vec<u32>,
    }
}

impl NodeRow {
    fn of(node: Node) -> Self {
        let (inner, first, count) = match node.kind() {
            Kind::Inner { children, .. } => (1, children, 0),
            Kind::Leaf { first, count } => (0, first, count),
        };
        Self {
            inner,
            first,
            count,
        }
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
        TreeRow {
            nodes: tree.nodes.iter().map(|&node| NodeRow::of(node)).collect(),
            names: tree.named,
        }
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
    /// The tree, as the library stores it; a node whose children are not there, are another's, or are deeper than a tree may
    /// be is taken for an empty leaf.
    pub fn tree(&self) -> Tree {
        let cut = self.cut();
        let node = |(row, i): (&NodeRow, usize)| match (cut[i], row.inner) {
            (true, _) => {
                let is_empty =
                    |i: usize| !cut[i] && (self.nodes[i].inner != 0 || self.nodes[i].count == 0);
                let occupied = (0..8).filter(|child| !is_empty(row.first as usize + child));
                Node::inner(row.first, occupied.fold(0, |bits, child| bits | 1 << child))
            }
            (false, 0) => Node::leaf(row.first, row.count.min(u32::MAX / 4)),
            (false, _) => Node::leaf(0, 0),
        };
        let mut nodes: Vec<_> = self.nodes.iter().zip(0..).map(node).collect();
        if nodes.is_empty() {
            nodes.push(Node::leaf(0, 0));
        }
        let names = self
            .nodes
            .iter()
            .map(|row| row.first.saturating_add(row.count));
        Tree {
            bounds: Aabb::new(self.min, self.max),
            named: (0..names.max().unwrap_or(0).min(1 << 16)).collect(),
            nodes,
        }
    }

    /// Which nodes have eight children of their own.
    fn cut(&self) -> Vec<bool> {
        let mut depths = vec![None; self.nodes.len()];
        depths[..1.min(self.nodes.len())].fill(Some(0));
        let mut cut = Vec::new();
        for (i, row) in self.nodes.iter().enumerate() {
            let first = row.first as usize;
            let below = depths.get(first..first.saturating_add(8));
            let can = row.inner != 0 && first > i && below == Some(&[None; 8][..]);
            let depth = depths[i].filter(|&depth| can && depth < Limits::DEEPEST);
            if let Some(depth) = depth {
                depths[first..first + 8].fill(Some(depth + 1));
            }
            cut.push(depth.is_some());
        }
        cut
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
