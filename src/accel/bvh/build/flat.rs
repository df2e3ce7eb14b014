//! Stage 3: the tree as an array, without pointers.

use crate::accel::bvh::build::tree::{Inside, Tree};
use crate::accel::bvh::pair::Pair;
use crate::math::aabb::Aabb;

/// A box with either two children or some shapes, in 32 bytes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Node {
    /// Holds all that is below.
    pub bounds: Aabb,
    /// Of a branch: which pair its children are. Of a leaf: its first shape, in the order of the leaves.
    pub first: u32,
    /// How many shapes a leaf has; 0 for a branch.
    pub count: u32,
}

impl Node {
    /// A leaf without shapes.
    pub const EMPTY: Self = Self {
        bounds: Aabb::EMPTY,
        first: 0,
        count: 0,
    };
}

/// A tree as an array of pairs of nodes, depth-first: a branch's left subtree follows it.
#[derive(Clone, Debug, PartialEq)]
pub struct Flat {
    /// The node of all.
    pub root: Option<Node>,
    /// All other nodes.
    pub pairs: Vec<Pair>,
    /// The numbers of the shapes, as they follow each other in the leaves.
    pub order: Vec<u32>,
}

impl Flat {
    /// Flattens a tree whose leaves hold the shapes in this order.
    pub fn new(tree: &Tree, order: Vec<u32>) -> Self {
        let mut pairs = Vec::with_capacity(order.len());
        let root = (!order.is_empty()).then(|| place(tree, &mut pairs, &mut 0));
        pairs.shrink_to_fit();
        Self { root, pairs, order }
    }
}

/// Appends what is below a subtree, and returns its node; `shapes` counts those in the leaves so far.
fn place(tree: &Tree, pairs: &mut Vec<Pair>, shapes: &mut u32) -> Node {
    let bounds = tree.bounds.into();
    match &tree.inside {
        &Inside::Leaf(count) => {
            let first = *shapes;
            *shapes += count;
            Node {
                bounds,
                first,
                count,
            }
        }
        Inside::Branch(children) => {
            let at = pairs.len();
            pairs.push(Pair::new([Node::EMPTY; 2]));
            let [left, right] = &**children;
            pairs[at] = Pair::new([place(left, pairs, shapes), place(right, pairs, shapes)]);
            Node {
                bounds,
                first: at as u32,
                count: 0,
            }
        }
    }
}
