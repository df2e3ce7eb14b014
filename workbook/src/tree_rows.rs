//! Boxes and trees of them as rows.

use crate::record::row;
use glam::Vec3;
use raybook::inside::bvh::{Flat, Link, Node, Pair};
use raybook::math::aabb::Aabb;

row! {
    /// A node of a tree in a list: the root is number 0.
    pub struct NodeRow {
        /// The least corner of its box, in metres.
        pub min: Vec3,
        /// The greatest corner of its box, in metres.
        pub max: Vec3,
        /// Of a branch: the number of its left child; the right one follows it. Of a leaf: the number of its
        /// first shape.
        pub first: u32,
        /// The number of shapes in a leaf; 0 for a branch.
        pub count: u32,
    }
}

row! {
    /// A box.
    pub struct BoxRow {
        /// The least corner, in metres.
        pub min: Vec3,
        /// The greatest corner, in metres.
        pub max: Vec3,
    }
}

/// The list of a tree's nodes.
pub fn to_rows(flat: &Flat) -> Vec<NodeRow> {
    let below = flat.pairs.iter().flat_map(Pair::nodes);
    let row = |node: Node| NodeRow {
        min: node.bounds.min,
        max: node.bounds.max,
        first: match node.link.count {
            0 => 1 + 2 * node.link.first,
            _ => node.link.first,
        },
        count: node.link.count,
    };
    flat.root.into_iter().chain(below).map(row).collect()
}

/// The tree of a list of nodes, over shapes in the order of its leaves.
pub fn to_flat(rows: &[NodeRow], shapes: usize) -> Flat {
    let node = |row: &NodeRow| Node {
        bounds: Aabb {
            min: row.min,
            max: row.max,
        },
        link: Link {
            first: match row.count {
                0 => row.first.saturating_sub(1) / 2,
                _ => row.first,
            },
            count: row.count,
        },
    };
    let below = rows.get(1..).unwrap_or_default();
    Flat {
        root: rows.first().map(node),
        pairs: below
            .chunks_exact(2)
            .map(|pair| Pair::new([node(&pair[0]), node(&pair[1])]))
            .collect(),
        order: (0..shapes as u32).collect(),
    }
}

impl From<&BoxRow> for Aabb {
    fn from(row: &BoxRow) -> Self {
        Self {
            min: row.min,
            max: row.max,
        }
    }
}
