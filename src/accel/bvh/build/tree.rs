//! Stage 2's result: a tree, still with pointers.

use crate::accel::bvh::build::item::Bounds;

/// A subtree.
#[derive(Clone, Debug)]
pub struct Tree {
    /// The smallest box that holds all of its shapes.
    pub bounds: Bounds,
    /// What is in it.
    pub inside: Inside,
}

/// What a subtree consists of.
#[derive(Clone, Debug)]
pub enum Inside {
    /// A number of shapes: the next ones in the order of the leaves.
    Leaf(u32),
    /// Two subtrees.
    Branch(Box<[Tree; 2]>),
}

/// No way from the root to a leaf passes more than this many branches: a search needs a stack of this size, and no more.
pub(crate) const MAX_DEPTH: u32 = 64;

/// The branches on the way to any of n shapes if they are halved again and again: ⌈log₂ n⌉.
///
/// A builder may cut as unevenly as it likes while `MAX_DEPTH` leaves room for that.
pub(crate) fn halvings(n: usize) -> u32 {
    usize::BITS - n.saturating_sub(1).leading_zeros()
}
