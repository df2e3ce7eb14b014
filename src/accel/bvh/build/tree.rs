//! Stage 2's result: a tree, still with pointers.

use crate::accel::bvh::build::item::Bounds;

/// A subtree.
#[derive(Clone, Debug)]
pub struct Tree {
    /// The smallest box that holds all of its shapes.
    pub bounds: Bounds,
    /// Its shapes or its two children.
    pub inside: Inside,
}

/// What a subtree consists of.
#[derive(Clone, Debug)]
pub enum Inside {
    /// A leaf with this number of shapes, which are the next ones in the order of the leaves.
    Leaf(u32),
    /// Two subtrees.
    Branch(Box<[Tree; 2]>),
}

/// Maximum number of branches on the way from the root to a leaf, so that a search's stack has a fixed size.
pub(crate) const MAX_DEPTH: u32 = 64;

/// The number of branches above each of n shapes if the shapes are halved again and again: ⌈log₂ n⌉.
///
/// A builder may split unevenly as long as [`MAX_DEPTH`] leaves room for these halvings.
pub(crate) fn halvings(n: usize) -> u32 {
    usize::BITS - n.saturating_sub(1).leading_zeros()
}
