//! The searches: near children first, and nothing beyond the nearest hit.

use super::Tree;
use super::lanes::Lanes;
use super::node::{CHILDREN, Link};
use super::stack::{PLACES, Places, Waiting};
use super::ray::WideRay;
use crate::accel::Count;
use crate::math::{interval::Interval, ray::Ray};
use crate::shape::{Hit, Shape};
use glam::vec2;

/// The nearest hit so far.
#[derive(Clone, Copy, Debug)]
pub struct Nearest {
    /// Which facet, by its place in the list.
    pub facet: u32,
    pub id: u32,
    /// Where.
    pub t: f32,
    /// b1, b2
    pub uv: [f32; 2],
}

/// Closest.
#[inline(always)]
pub fn closest<L: Lanes>(
    lanes: L,
    tree: &Tree,
    ray: &Ray,
    within: Interval,
    count: &mut impl Count,
) -> Option<Nearest> {
    let wide = WideRay::new(ray, within.min, tree.largest);
    closest_below(lanes, tree, tree.root?, ray, &wide, within.max, None, count)
}

#[cold]
#[inline(never)]
#[allow(clippy::too_many_arguments)]
fn deeper<L: Lanes>(
    lanes: L,
    tree: &Tree,
    link: Link,
    ray: &Ray,
    wide: WideRay,
    limit: f32,
    best: Option<Nearest>,
    count: &mut impl Count,
) -> Option<Nearest> {
    closest_below(lanes, tree, link, ray, &wide, limit, best, count)
}

#[inline(always)]
#[allow(clippy::too_many_arguments)]
fn closest_below<L: Lanes>(
    lanes: L,
    tree: &Tree,
    mut link: Link,
    ray: &Ray,
    wide: &WideRay,
    mut limit: f32,
    mut best: Option<Nearest>,
    count: &mut impl Count,
) -> Option<Nearest> {
    let mut stack = Places::new();
    let mut len = 0;
    loop {
        if let Some(leaf) = link.as_leaf() {
            test_leaf(lanes, tree, leaf, ray, wide, &mut limit, &mut best, count);
        } else if len + CHILDREN > PLACES {
            best = deeper(lanes, tree, link, ray, *wide, limit, best, count);
            if let Some(best) = best { limit = best.t.next_up(); }
        } else {
            let node = &tree.nodes[link.index()];
            count.tested_box();
            let (mask, t) = lanes.boxes(node, wide, limit);
            if mask != 0 {
                let lane = mask.trailing_zeros() as usize % CHILDREN;
                let mut others = mask & (mask - 1);
                link = node.links[lane];
                if others == 0 {
                    continue;
                }
                lanes.prefetch(tree, link);
                let mut near = Waiting::new(t[lane], link);
                let base = len;
                while others != 0 {
                    let lane = others.trailing_zeros() as usize % CHILDREN;
                    others &= others - 1;
                    let other = Waiting::new(t[lane], node.links[lane]);
                    lanes.prefetch(tree, other.link());
                    stack.insert(base, len, near.max(other));
                    near = near.min(other);
                    len += 1;
                }
                link = near.link();
                continue;
            }
        }
        loop {
            if len == 0 { return best; }
            len -= 1;
            let next = stack.0[len];
            if next.t() < limit {
                link = next.link();
                break;
            }
        }
    }
}

#[inline(always)]
#[allow(clippy::too_many_arguments)]
fn test_leaf<L: Lanes>(
    lanes: L,
    tree: &Tree,
    leaf: usize,
    ray: &Ray,
    wide: &WideRay,
    limit: &mut f32,
    best: &mut Option<Nearest>,
    count: &mut impl Count,
) {
    let leaf = &tree.leaves[leaf];
    for _ in leaf.facets() {
        count.tested_shape();
    }
    let hits = lanes.triangles(leaf, wide, *limit);
    let mut mask = hits.mask;
    while mask != 0 {
        let lane = mask.trailing_zeros() as usize;
        mask &= mask - 1;
        let lane = lane % 4;
        let found = Nearest { facet: leaf.facets[lane], id: leaf.ids[lane], t: hits.t[lane], uv: [hits.b1[lane], hits.b2[lane]] };
        take(found, limit, best);
    }
    let mut mask = hits.unsure;
    while mask != 0 {
        let lane = mask.trailing_zeros() as usize;
        mask &= mask - 1;
        if let Some(hit) = tree.facets[leaf.facets[lane] as usize].hit(ray, Interval::new(wide.min, *limit)) {
            take(Nearest { facet: leaf.facets[lane], id: leaf.ids[lane], t: hit.t, uv: hit.uv.to_array() }, limit, best);
        }
    }
}

#[inline(always)]
fn take(found: Nearest, limit: &mut f32, best: &mut Option<Nearest>) {
    if best.is_none_or(|b| found.t < b.t || (found.t == b.t && found.facet < b.facet)) {
        *best = Some(found);
        *limit = found.t.next_up();
    }
}

/// Any.
#[inline(always)]
pub fn any<L: Lanes>(lanes: L, tree: &Tree, ray: &Ray, within: Interval) -> bool {
    let wide = WideRay::new(ray, within.min, tree.largest);
    tree.root.is_some_and(|root| any_below(lanes, tree, root, ray, &wide, within))
}

#[cold]
#[inline(never)]
fn deeper_any<L: Lanes>(lanes: L, tree: &Tree, link: Link, ray: &Ray, wide: WideRay, within: Interval) -> bool {
    any_below(lanes, tree, link, ray, &wide, within)
}

#[inline(always)]
fn any_below<L: Lanes>(lanes: L, tree: &Tree, mut link: Link, ray: &Ray, wide: &WideRay, within: Interval) -> bool {
    let mut stack = [Link(0); 64];
    let mut len = 0;
    loop {
        if let Some(leaf) = link.as_leaf() {
            let leaf = &tree.leaves[leaf];
            let hits = lanes.triangles(leaf, wide, within.max);
            if hits.mask != 0 {
                return true;
            }
            let mut mask = hits.unsure;
            while mask != 0 {
                let lane = mask.trailing_zeros() as usize;
                mask &= mask - 1;
                if tree.facets[leaf.facets[lane] as usize].blocks(ray, within) {
                    return true;
                }
            }
        } else if len + CHILDREN > 64 {
            if deeper_any(lanes, tree, link, ray, *wide, within) {
                return true;
            }
        } else {
            let node = &tree.nodes[link.index()];
            let (mask, _) = lanes.boxes(node, wide, within.max);
            if mask != 0 {
                link = node.links[mask.trailing_zeros() as usize % CHILDREN];
                let others = mask & (mask - 1);
                if others != 0 {
                    stack[len..len + CHILDREN].copy_from_slice(&lanes.packed(node, others));
                    len += others.count_ones() as usize;
                }
                continue;
            }
        }
        if len == 0 {
            return false;
        }
        len -= 1;
        link = stack[len];
    }
}

impl Nearest {
    pub fn hit(&self) -> Hit {
        Hit { t: self.t, uv: vec2(self.uv[0], self.uv[1]), id: self.id }
    }
}
