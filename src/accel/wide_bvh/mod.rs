//! The wide bounding volume hierarchy: eight children, tested at once.
//!
//! ```
//! use raybook::prelude::*;
//!
//! let mesh = raybook::shape::teapot::mesh(4);
//! let (wide, list) = (WideBvh::new(mesh.facets()), List::new(mesh.facets()));
//! let ray = Ray::new(vec3(0.1, 9.0, 0.2), -Dir3::Y);
//! let by_wide = wide.closest(&ray, Interval::AHEAD).map(|(facet, _)| facet.id);
//! let by_list = list.closest(&ray, Interval::AHEAD).map(|(facet, _)| facet.id);
//! assert!(by_wide.is_some() && by_wide == by_list); // the same triangle of the lid
//! ```

#![expect(
    clippy::inline_always,
    reason = "a function called from AVX2 or AVX-512 code is compiled with these only where it is inlined"
)]

#[cfg(target_arch = "x86_64")]
mod avx2;
#[cfg(target_arch = "x86_64")]
mod avx512;
mod batch;
pub(crate) mod build;
pub(crate) mod collapse;
mod fours;
mod kernel;
mod lanes;
mod nearest;
pub(crate) mod node;
pub(crate) mod optimal;
mod portable;
#[cfg(target_arch = "x86_64")]
mod proof;
mod ray;
mod refit;
mod search;
pub(crate) mod spatial;
mod stack;
pub(crate) mod tree;
mod validate;
mod walk;

use crate::accel::bvh::build::Method;
use crate::accel::{
    Accel, Count,
    bounded::{bounded, is_bounded},
    list::List,
};
use crate::math::{aabb::Aabb, interval::Interval, ray::Ray};
use crate::shape::{Hit, Shape, mesh::Facet};
use batch::Batch;
pub use kernel::Kernel;
use lanes::{Lanes, Work};
use nearest::Nearest;
use node::{CHILDREN, Link, Node};
use portable::Portable;
use ray::WideRay;
use search::{Any, Closest};
use tree::Tree;

/// Facets with finite boxes in a tree of eight children per node and up to eight triangles per leaf.
///
/// A node that a ray comes to counts as one box tested: its eight are tested at once.
#[derive(Clone, Debug)]
pub struct WideBvh {
    tree: Tree,
    /// Facets without a finite box, if there are any.
    beside: Option<Box<List<Facet>>>,
    kernel: Kernel,
}

/// Size of the nodes and leaves, in bytes, up to which the last cache of a large processor holds them. Measured with caches of 32 MB and
/// more: benches/peers/README.md.
const IN_LAST_CACHE: usize = 16 << 20;

impl WideBvh {
    /// The tree that is best for its time, with the best instructions of this processor. Long thin triangles are cut into parts.
    pub fn new(facets: Vec<Facet>) -> Self {
        Self::of(facets, build::best)
    }

    /// A tree that is collapsed from a binary one made by a method of choice. No triangle is in two leaves: it takes less
    /// time and memory, and suits facets that will move ([`WideBvh::refit`]).
    pub fn build(facets: Vec<Facet>, method: Method) -> Self {
        Self::of(facets, |facets| build::build(facets, method, &build::COST))
    }

    /// A tree with cuts through triangles, also where they do not pay.
    pub(crate) fn cut(facets: Vec<Facet>) -> Self {
        Self::of(facets, build::cut)
    }

    fn of(facets: Vec<Facet>, build: impl FnOnce(Vec<Facet>) -> Tree) -> Self {
        let all = facets.len();
        let (facets, beside) = bounded(facets);
        Self {
            beside: (facets.len() < all).then(|| Box::new(beside)),
            tree: build(facets),
            kernel: Kernel::all()[0],
        }
    }

    /// The same tree, searched by other instructions than the best of this processor.
    #[must_use]
    pub fn with(self, kernel: Kernel) -> Self {
        Self { kernel, ..self }
    }

    /// The nearest hit of each ray, as [`Accel::closest`] finds it.
    ///
    /// Faster than one ray after the other where rays go their own ways through a large mesh, for then they wait for memory.
    /// In a tree whose nodes and leaves take up to 16 MiB, they do so seldom, and are followed one after the other.
    pub fn closest_many(&self, rays: &[Ray], within: Interval) -> Vec<Option<(&Facet, Hit)>> {
        if self.tree.searched_bytes() > IN_LAST_CACHE {
            return self.in_turns(rays, within);
        }
        rays.iter().map(|ray| self.closest(ray, within)).collect()
    }

    /// The nearest hit of each ray, with several of them in flight.
    pub(crate) fn in_turns(&self, rays: &[Ray], within: Interval) -> Vec<Option<(&Facet, Hit)>> {
        let tree = &self.tree;
        let mut answers = self.run(within, Batch { tree, rays, within });
        if self.beside.is_some() {
            for (ray, in_tree) in rays.iter().zip(&mut answers) {
                *in_tree = self.or_beside(ray, within, *in_tree, &mut ());
            }
        }
        answers
    }

    /// The same tree over facets that have moved: as many as before, and in the same order.
    ///
    /// It takes a small part of the time of a build, and the answers are those of a new tree, bit for bit. But neighbours stay
    /// together even when they drift apart: a ray then takes more steps, and after a while a new tree pays. Triangles that were
    /// cut are whole again, in all of their leaves: long thin triangles that will move are better built by [`WideBvh::build`]. If
    /// the number of facets differs, or a facet has no finite box, before or now, the tree is built anew.
    ///
    /// ```
    /// use raybook::accel::{Accel, wide_bvh::WideBvh};
    /// use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
    /// use raybook::shape::teapot;
    ///
    /// let mut facets = teapot::mesh(4).facets();
    /// let mut tree = WideBvh::new(facets.clone());
    /// for facet in &mut facets {
    ///     facet.corners = facet.corners.map(|p| p + 10.0);
    /// }
    /// tree.refit(facets);
    /// let above = Ray::new(glam::vec3(10.0, 20.0, 10.0), -Dir3::Y);
    /// assert!(tree.any(&above, Interval::AHEAD));
    /// ```
    pub fn refit(&mut self, facets: Vec<Facet>) {
        let as_before = self.beside.is_none() && facets.len() == self.tree.facets.len();
        if as_before && facets.iter().all(|facet| is_bounded(&facet.bounds())) {
            refit::refit(&mut self.tree, facets);
        } else {
            *self = Self::new(facets).with(self.kernel);
        }
    }

    /// Checks the invariants of `accel/wide_bvh/validate.rs`.
    ///
    /// # Errors
    /// Says which one is broken, and where.
    pub fn validate(&self) -> Result<(), String> {
        validate::validate(&self.tree)
    }

    /// The tree.
    pub(crate) fn tree(&self) -> &Tree {
        &self.tree
    }

    /// Memory in use, in bytes.
    pub fn bytes(&self) -> usize {
        self.tree.bytes()
    }

    /// Does the work. Special instructions compare distances as integers, which is right from 0 on.
    #[inline(always)]
    fn run<W: Work>(&self, within: Interval, work: W) -> W::Answer {
        if within.min >= 0.0 {
            self.kernel.run(work)
        } else {
            Portable.run(work)
        }
    }

    /// What is nearest in the tree.
    #[inline(never)] // so it is compiled here: what a program compiles itself is slower, for its options are others
    fn nearest(&self, ray: &Ray, within: Interval) -> Nearest {
        let (tree, count) = (&self.tree, &mut ());
        self.run(
            within,
            Closest {
                tree,
                ray,
                within,
                count,
            },
        )
    }

    /// What was found in the tree, or something nearer beside it.
    #[inline(always)]
    fn or_beside<'a>(
        &'a self,
        ray: &Ray,
        within: Interval,
        in_tree: Option<(&'a Facet, Hit)>,
        count: &mut impl Count,
    ) -> Option<(&'a Facet, Hit)> {
        match &self.beside {
            None => in_tree,
            Some(list) => {
                let within = in_tree.map_or(within, |(_, hit)| within.before(hit.t));
                list.closest_counted(ray, within, count).or(in_tree)
            }
        }
    }
}

impl Accel<Facet> for WideBvh {
    #[inline]
    fn closest(&self, ray: &Ray, within: Interval) -> Option<(&Facet, Hit)> {
        let in_tree = self.nearest(ray, within).of(&self.tree.facets);
        self.or_beside(ray, within, in_tree, &mut ())
    }

    fn closest_counted(
        &self,
        ray: &Ray,
        within: Interval,
        count: &mut impl Count,
    ) -> Option<(&Facet, Hit)> {
        let tree = &self.tree;
        let nearest = self.run(
            within,
            Closest {
                tree,
                ray,
                within,
                count: &mut *count,
            },
        );
        self.or_beside(ray, within, nearest.of(&tree.facets), count)
    }

    fn any(&self, ray: &Ray, within: Interval) -> bool {
        let tree = &self.tree;
        self.run(within, Any { tree, ray, within })
            || matches!(&self.beside, Some(list) if list.any(ray, within))
    }
}

/// Which of eight boxes a ray meets within an interval, as bits, and where it enters them.
pub(crate) fn eight_boxes(
    boxes: &[Aabb; CHILDREN],
    ray: &Ray,
    within: Interval,
) -> (u32, [f32; CHILDREN]) {
    let node = Node::new(boxes.map(|bounds| (bounds, Link::NONE)));
    let all = boxes.iter().fold(Aabb::EMPTY, |all, b| all.union(b));
    let largest = all.min.abs().max(all.max.abs());
    let ready = WideRay::new(ray, within.min, largest.into());
    Portable.boxes(&node, &ready, within.max)
}
