//! The octree without the shapes: cells in cells, and in the smallest cells the numbers of shapes.

use crate::math::aabb::Aabb;
use glam::{BVec3, Vec3};
use std::ops::Range;

/// A tree of cells in two arrays: a node refers to another node by its number, not by an address.
///
/// Node 0 is the root. The eight children of a node are side by side, 64 bytes in all. The child's number is 4·z + 2·y + x,
/// where x is 0 in the lower half of the cell along x and 1 in the upper half; y and z likewise.
#[derive(Clone, Debug)]
pub struct Tree {
    /// The root's cell.
    pub bounds: Aabb,
    /// The nodes; a node's children come after it.
    pub nodes: Vec<Node>,
    /// The numbers of the leaves' shapes, leaf after leaf. A shape that lies in several leaves is named in each of them.
    pub named: Vec<u32>,
}

/// A node in eight bytes; [`Node::kind`] unpacks it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Node {
    /// The first child, or the place in [`Tree::named`] where the leaf's shapes begin.
    first: u32,
    /// The number of shapes of a leaf; or [`Node::INNER`] and one bit per child that is not empty.
    rest: u32,
}

/// What a node is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A cell cut in eight.
    Inner {
        /// The first of the eight children.
        children: u32,
        /// Bit i is set if child i is not an empty leaf.
        occupied: u8,
    },
    /// A cell that is not cut. Its shapes are a part of [`Tree::named`].
    Leaf {
        /// Where the leaf's shapes begin.
        first: u32,
        /// Number of shapes.
        count: u32,
    },
}

impl Node {
    const INNER: u32 = 1 << 31;

    /// A leaf whose shapes are `named[first..first + count]`.
    pub fn leaf(first: u32, count: u32) -> Self {
        debug_assert!(count < Self::INNER, "a leaf of 2³¹ shapes");
        Self { first, rest: count }
    }

    /// A node with eight children.
    pub fn inner(children: u32, occupied: u8) -> Self {
        Self {
            first: children,
            rest: Self::INNER | u32::from(occupied),
        }
    }

    /// The kind of the node.
    pub fn kind(self) -> Kind {
        let Self { first, rest } = self;
        if rest & Self::INNER == 0 {
            Kind::Leaf { first, count: rest }
        } else {
            Kind::Inner {
                children: first,
                occupied: rest as u8,
            }
        }
    }
}

// ANCHOR: octree_child
/// The number of the child in which a point of a cell lies: 4·z + 2·y + x, each 1 in the upper half of the cell, else 0.
///
/// A point on a middle plane counts as above it.
pub fn child_at(cell: &Aabb, p: Vec3) -> usize {
    let above = p.cmpge(cell.center());
    above.bitmask() as usize
}
// ANCHOR_END: octree_child

/// The cell of child i.
///
/// [`child_at`] and the walk compare with the same middle planes, to the last bit, so the eight cells leave no gap.
pub fn child_cell(cell: &Aabb, i: usize) -> Aabb {
    let middle = cell.center();
    let above = BVec3::new(i & 1 != 0, i & 2 != 0, i & 4 != 0);
    Aabb {
        min: Vec3::select(above, middle, cell.min),
        max: Vec3::select(above, cell.max, middle),
    }
}

/// A node, with its cell and its depth.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    /// The node's number.
    pub node: u32,
    /// The node's cell.
    pub cell: Aabb,
    /// Number of cuts between the root and the node.
    pub depth: u32,
}

impl Tree {
    /// The part of [`Tree::named`] that a leaf names; nothing for an inner node.
    pub fn range(&self, node: u32) -> Range<usize> {
        match self.nodes[node as usize].kind() {
            Kind::Leaf { first, count } => first as usize..(first + count) as usize,
            Kind::Inner { .. } => 0..0,
        }
    }

    /// The shapes that a leaf names.
    pub fn shapes_in(&self, leaf: u32) -> &[u32] {
        &self.named[self.range(leaf)]
    }

    /// The root.
    pub fn root(&self) -> Place {
        Place {
            node: 0,
            cell: self.bounds,
            depth: 0,
        }
    }

    /// The eight children of a node, in order; none for a leaf.
    pub fn children(&self, of: &Place) -> Vec<Place> {
        let Kind::Inner { children, .. } = self.nodes[of.node as usize].kind() else {
            return Vec::new();
        };
        let place = |i: usize| Place {
            node: children + i as u32,
            cell: child_cell(&of.cell, i),
            depth: of.depth + 1,
        };
        (0..8).map(place).collect()
    }

    /// The leaf in which a point of the root's cell lies.
    pub fn leaf_at(&self, p: Vec3) -> Place {
        let mut at = self.root();
        while let Kind::Inner { children, .. } = self.nodes[at.node as usize].kind() {
            let i = child_at(&at.cell, p);
            at = Place {
                node: children + i as u32,
                cell: child_cell(&at.cell, i),
                depth: at.depth + 1,
            };
        }
        at
    }

    /// Every node with its cell, parents before their children.
    pub fn places(&self) -> Vec<Place> {
        let mut places = vec![self.root()];
        let mut next = 0;
        while let Some(place) = places.get(next).copied() {
            places.extend(self.children(&place));
            next += 1;
        }
        places
    }
}
