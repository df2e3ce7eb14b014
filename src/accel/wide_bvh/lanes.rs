//! What the searches ask of a processor.

use super::node::{CHILDREN, Leaf, Link, Node, TRIANGLES};
use super::ray::WideRay;
use super::tree::Tree;

/// Tests of several boxes, and of several triangles, at once.
pub(super) trait Lanes: Copy {
    /// The children that the ray meets before `max`, as bits, and where it enters each of them.
    fn boxes(self, node: &Node, ray: &WideRay, max: f32) -> (u32, [f32; CHILDREN]);

    /// The triangles that the ray hits before `max`, if there are any.
    fn triangles(self, leaf: &Leaf, ray: &WideRay, max: f32) -> Option<Struck>;

    /// Asks the memory for a child that is needed soon.
    fn fetch_next(self, tree: &Tree, link: Link);

    /// Asks the memory for a child that is met, one of several: into the second-level cache, for the first one is too small for
    /// all that may wait.
    fn fetch_met(self, tree: &Tree, link: Link);
}

/// A search that any [`Lanes`] can do. It is compiled once for each of them.
pub(super) trait Work {
    /// What it finds.
    type Answer;

    /// Does it.
    fn with<L: Lanes>(self, lanes: L) -> Self::Answer;
}

/// Triangles that a ray hits.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Struck {
    /// Bit i: triangle i.
    pub mask: u32,
    /// Bit i: triangle i is hit too near an edge, or is too small or too large: only the test of one triangle can tell.
    pub unsure: u32,
    /// Distances.
    pub t: [f32; TRIANGLES],
    /// Barycentrics of the second corners.
    pub b1: [f32; TRIANGLES],
    /// Barycentrics of the third corners.
    pub b2: [f32; TRIANGLES],
}
