//! Octrees as rows.

use crate::record::row;
use raybook::accel::octree::build::Limits;
use raybook::inside::octree::{Kind, Node, Tree};
use raybook::math::aabb::Aabb;

row! {
    /// A node of a tree.
    pub struct NodeRow {
        /// 1 for a node with eight children, 0 for a leaf.
        pub inner: u32,
        /// Of a node with children: the number of its first child. Of a leaf: the place in the list of names
        /// where its names begin.
        pub first: u32,
        /// The number of shapes that a leaf names; 0 for a node with children.
        pub count: u32,
    }
}

row! {
    /// A tree: its nodes, the root first, the eight children of a node side by side; and the names in its leaves.
    pub struct TreeRow {
        /// The nodes: the root first, the eight children of a node side by side.
        pub nodes: Vec<NodeRow>,
        /// The shapes that the leaves name, by their numbers from 0.
        pub names: Vec<u32>,
    }
}

impl From<Node> for NodeRow {
    fn from(node: Node) -> Self {
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

impl From<Tree> for TreeRow {
    fn from(tree: Tree) -> Self {
        Self {
            nodes: tree.nodes.into_iter().map(NodeRow::from).collect(),
            names: tree.named,
        }
    }
}

/// The tree of a list of nodes, as the library stores it.
///
/// A node whose children are not there, are another's too, or are deeper than a tree may be, is taken for an empty leaf.
pub fn to_tree(bounds: Aabb, rows: &[NodeRow]) -> Tree {
    let cut = cut(rows);
    let is_empty = |i: usize| !cut[i] && (rows[i].inner != 0 || rows[i].count == 0);
    let node = |(row, cut): (&NodeRow, &bool)| match (cut, row.inner) {
        (true, _) => {
            let occupied = (0..8).filter(|child| !is_empty(row.first as usize + child));
            Node::inner(row.first, occupied.fold(0, |bits, child| bits | 1 << child))
        }
        (false, 0) => Node::leaf(row.first, row.count.min(u32::MAX / 4)),
        (false, _) => Node::leaf(0, 0),
    };
    let mut nodes: Vec<_> = rows.iter().zip(&cut).map(node).collect();
    if nodes.is_empty() {
        nodes.push(Node::leaf(0, 0));
    }
    let names = rows.iter().map(|row| row.first.saturating_add(row.count));
    Tree {
        bounds,
        named: (0..names.max().unwrap_or(0).min(1 << 16)).collect(),
        nodes,
    }
}

/// Which nodes have eight children of their own.
fn cut(rows: &[NodeRow]) -> Vec<bool> {
    let mut depths = vec![None; rows.len()];
    depths[..1.min(rows.len())].fill(Some(0));
    let mut cut = Vec::new();
    for (i, row) in rows.iter().enumerate() {
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
