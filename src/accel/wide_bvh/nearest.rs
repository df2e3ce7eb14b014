//! What a search carries along: the ray, and the nearest hit so far.

use super::lanes::Lanes;
use super::node::{Leaf, NO_FACET};
use super::ray::WideRay;
use super::tree::Tree;
use crate::accel::Count;
use crate::math::{interval::Interval, ray::Ray};
use crate::shape::{Hit, Shape, mesh::Facet};
use glam::Vec2;

/// The nearest hit so far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Nearest {
    /// What counts from now on has t < limit.
    pub limit: f32,
    /// Which facet was hit, by its place in the list; [`NO_FACET`] for none.
    pub facet: u32,
    /// Where.
    pub hit: Hit,
}

impl Nearest {
    /// Nothing yet, with an end of the distances that count.
    pub(super) fn nothing(limit: f32) -> Self {
        let hit = Hit {
            t: f32::INFINITY,
            uv: Vec2::ZERO,
            id: 0,
        };
        Self {
            limit,
            facet: NO_FACET,
            hit,
        }
    }

    /// The hit, if there is one.
    #[inline(always)]
    pub(super) fn hit(&self) -> Option<Hit> {
        (self.facet != NO_FACET).then_some(self.hit)
    }

    /// The facet that is hit and the hit, if there is one.
    #[inline(always)]
    pub(super) fn of<'a>(&self, facets: &'a [Facet]) -> Option<(&'a Facet, Hit)> {
        self.hit().map(|hit| (&facets[self.facet as usize], hit))
    }

    /// The nearer of this and another hit: of two at the same distance, that of the facet which is first in the list.
    ///
    /// So the answer does not depend on the tree. The limit is the next number after t, for one at t itself must be seen.
    #[inline(always)]
    #[must_use]
    pub(super) fn or(self, facet: u32, hit: Hit) -> Self {
        if hit.t < self.hit.t || (hit.t == self.hit.t && facet < self.facet) {
            Self {
                limit: hit.t.next_up(),
                facet,
                hit,
            }
        } else {
            self
        }
    }

    /// The nearer of this and what was found elsewhere.
    #[inline(always)]
    #[must_use]
    pub(super) fn or_else(self, other: Self) -> Self {
        self.or(other.facet, other.hit)
    }
}

/// A ray that seeks.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seeker<'r> {
    /// As it is.
    pub ray: &'r Ray,
    /// Made ready.
    pub wide: WideRay,
}

impl<'r> Seeker<'r> {
    /// Makes a ray ready for a tree; nothing at or before `min` counts.
    #[inline(always)]
    pub(super) fn new(ray: &'r Ray, min: f32, tree: &Tree) -> Self {
        Self {
            ray,
            wide: WideRay::new(ray, min, tree.largest),
        }
    }

    /// The nearest hit so far, and in a leaf.
    #[inline(always)]
    pub(super) fn test<L: Lanes>(
        &self,
        lanes: L,
        tree: &Tree,
        leaf: &Leaf,
        mut found: Nearest,
        count: &mut impl Count,
    ) -> Nearest {
        for _ in leaf.facets() {
            count.tested_shape();
        }
        let Some(struck) = lanes.triangles(leaf, &self.wide, found.limit) else {
            return found;
        };
        for lane in bits(struck.mask) {
            let hit = Hit {
                t: struck.t[lane],
                uv: Vec2::new(struck.b1[lane], struck.b2[lane]),
                id: leaf.ids[lane],
            };
            found = found.or(leaf.facets[lane], hit);
        }
        if struck.unsure != 0 {
            let within = Interval::new(self.wide.min, found.limit);
            found = found.or_else(test_each(tree, leaf, struck.unsure, self.ray, within));
        }
        found
    }

    /// Whether anything in a leaf is hit before `max`.
    #[inline(always)]
    pub(super) fn test_any<L: Lanes>(&self, lanes: L, tree: &Tree, leaf: &Leaf, max: f32) -> bool {
        let Some(struck) = lanes.triangles(leaf, &self.wide, max) else {
            return false;
        };
        let within = Interval::new(self.wide.min, max);
        struck.mask != 0
            || struck.unsure != 0 && test_any_of(tree, leaf, struck.unsure, self.ray, within)
    }
}

/// The nearest hit of some triangles of a leaf, tested one by one.
///
/// Neither the ray made ready nor the nearest hit is given by its address, so that the loop over the nodes keeps both in registers.
#[cold] // what that loop keeps in registers is then saved here, and not before it
#[inline(never)]
fn test_each(tree: &Tree, leaf: &Leaf, lanes: u32, ray: &Ray, within: Interval) -> Nearest {
    let mut found = Nearest::nothing(within.max);
    for lane in bits(lanes) {
        let facet = &tree.facets[leaf.facets[lane] as usize];
        if let Some(hit) = facet.hit(ray, Interval::new(within.min, found.limit)) {
            found = found.or(leaf.facets[lane], hit);
        }
    }
    found
}

/// Whether any of some triangles of a leaf is hit, tested one by one.
#[cold]
#[inline(never)]
fn test_any_of(tree: &Tree, leaf: &Leaf, lanes: u32, ray: &Ray, within: Interval) -> bool {
    let blocks = |lane: usize| tree.facets[leaf.facets[lane] as usize].blocks(ray, within);
    bits(lanes).any(blocks)
}

/// The numbers of the bits that are set.
#[inline(always)]
fn bits(mut mask: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lane = (mask != 0).then(|| mask.trailing_zeros() as usize)?;
        mask &= mask - 1;
        Some(lane)
    })
}
