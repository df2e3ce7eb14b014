//! Stage 3: the tree as an array, without pointers.

use crate::accel::bvh::build::tree::{Inside, Tree};
use crate::accel::bvh::pair::{Link, Pair};
use crate::math::aabb::Aabb;

/// A node in 32 bytes: a box, with either two children or some shapes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// The box that holds everything below the node.
    pub bounds: Aabb,
    /// The children or the shapes.
    pub link: Link,
}

impl Node {
    /// A placeholder for a node.
    pub const NONE: Self = Self {
        bounds: Aabb::EMPTY,
        link: Link::NONE,
    };
}

/// A tree as an array of pairs of nodes, depth-first: a branch's left subtree comes right after its pair.
#[derive(Clone, Debug, PartialEq)]
pub struct Flat {
    /// The root; `None` if there are no shapes.
    pub root: Option<Node>,
    /// All other nodes.
    pub pairs: Vec<Pair>,
    /// The numbers of the shapes, in the order of the leaves.
    pub order: Vec<u32>,
}

impl Flat {
    /// Flattens a tree; `order` lists the shapes as its leaves hold them, one leaf after another.
    pub fn new(tree: &Tree, order: Vec<u32>) -> Self {
        let mut pairs = Vec::with_capacity(order.len());
        let root = (!order.is_empty()).then(|| place(tree, &mut pairs, &mut 0));
        Self { root, pairs, order }
    }
}

/// Appends the nodes below a subtree to `pairs`, and returns the subtree's own node; `shapes` counts the shapes in the leaves
/// before.
fn place(tree: &Tree, pairs: &mut Vec<Pair>, shapes: &mut u32) -> Node {
    let bounds = tree.bounds.into();
    let (first, count) = match &tree.inside {
        &Inside::Leaf(count) => {
            let first = *shapes;
            *shapes += count;
            (first, count)
        }
        Inside::Branch(children) => {
            let at = pairs.len();
            pairs.push(Pair::new([Node::NONE; 2])); // reserved: a pair comes before those of its children
            let [left, right] = &**children;
            pairs[at] = Pair::new([place(left, pairs, shapes), place(right, pairs, shapes)]);
            (at as u32, 0)
        }
    };
    let link = Link { first, count };
    Node { bounds, link }
}
