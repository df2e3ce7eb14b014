//! The searches of one ray: near children first, and nothing beyond the nearest hit.

use super::lanes::Lanes;
use super::nearest::{Nearest, Seeker};
use super::node::{CHILDREN, Leaf, Link, Node};
use super::stack::{PLACES, Places, Waiting};
use super::tree::Tree;
use crate::accel::Count;
use crate::math::{interval::Interval, ray::Ray};

// ANCHOR: wide_closest
/// The nearest hit at or below the node or leaf `link`, if it is nearer than what was found so far.
///
/// Eight boxes are tested at once. Of the children met, the nearest is next and the others wait, the farthest at the bottom
/// of the stack; a child whose box begins beyond the nearest hit so far is dropped.
#[inline(always)]
pub(super) fn closest<L: Lanes>(
    lanes: L,
    tree: &Tree,
    mut link: Link,
    seeker: &Seeker,
    mut found: Nearest,
    count: &mut impl Count,
) -> Nearest {
    let (mut stack, mut height) = (Places::new(), 0);
    loop {
        if let Some(leaf) = link.as_leaf() {
            found = seeker.test(lanes, tree, &tree.leaves[leaf], found, count);
        } else {
            let node = &tree.nodes[link.index()];
            count.tested_box();
            let (mut met, t) = lanes.boxes(node, &seeker.wide, found.limit);
            if met.is_power_of_two() {
                // Only one, as most often: nothing to sort, and no need of the stack.
                link = node.links[first(&mut met)];
                continue;
            }
            if height + CHILDREN > PLACES {
                let within = Interval::new(seeker.wide.min, found.limit);
                found = found.or_else(deeper(lanes, tree, link, seeker.ray, within, count));
            } else if met != 0 {
                let fetch = |link| lanes.fetch_met(tree, link);
                link = nearest(node, met, &t, &mut stack, &mut height, fetch);
                continue;
            }
        }
        loop {
            if height == 0 {
                return found;
            }
            height -= 1;
            let next = stack.at(height);
            if next.t() < found.limit {
                link = next.link();
                break;
            }
        }
    }
}
// ANCHOR_END: wide_closest

/// The nearest of the children that are met; the others are put aside. All are fetched.
#[inline(always)]
pub(super) fn nearest(
    node: &Node,
    mut met: u32,
    t: &[f32; CHILDREN],
    stack: &mut Places,
    height: &mut usize,
    fetch: impl Fn(Link),
) -> Link {
    let child = |lane: usize| Waiting::new(t[lane], node.links[lane]);
    let (mut near, base) = (child(first(&mut met)), *height);
    fetch(near.link());
    while met != 0 {
        let other = child(first(&mut met));
        fetch(other.link());
        stack.insert(base, *height, near.max(other));
        *height += 1;
        near = near.min(other);
    }
    near.link()
}

/// Takes the first lane out of those that are met.
#[inline(always)]
pub(super) fn first(met: &mut u32) -> usize {
    let lane = met.trailing_zeros() as usize % CHILDREN;
    *met &= *met - 1;
    lane
}

/// The same with a stack of its own: a tree may be deeper than any stack of fixed size.
#[cold]
#[inline(never)]
fn deeper<L: Lanes>(
    lanes: L,
    tree: &Tree,
    link: Link,
    ray: &Ray,
    within: Interval,
    count: &mut impl Count,
) -> Nearest {
    let seeker = Seeker::new(ray, within.min, tree);
    closest(
        lanes,
        tree,
        link,
        &seeker,
        Nearest::nothing(within.max),
        count,
    )
}

/// Whether anything is hit at or below a node or leaf. No child needs to be nearer than another, so nothing is sorted.
///
/// A leaf is prefetched, and tested when the next one is met.
#[inline(always)]
pub(super) fn any<L: Lanes>(
    lanes: L,
    tree: &Tree,
    mut link: Link,
    seeker: &Seeker,
    max: f32,
) -> bool {
    let (mut stack, mut height) = ([link; PLACES], 0);
    let mut aside: Option<&Leaf> = None;
    let is_hit = |leaf: &Leaf| seeker.test_any(lanes, tree, leaf, max);
    loop {
        if let Some(leaf) = link.as_leaf() {
            lanes.fetch_next(tree, link);
            if aside.replace(&tree.leaves[leaf]).is_some_and(is_hit) {
                return true;
            }
        } else {
            let node = &tree.nodes[link.index()];
            let (mut met, _) = lanes.boxes(node, &seeker.wide, max);
            if met.is_power_of_two() {
                link = node.links[first(&mut met)];
                continue;
            }
            if height + CHILDREN > PLACES {
                let within = Interval::new(seeker.wide.min, max);
                if deeper_any(lanes, tree, link, seeker.ray, within) {
                    return true;
                }
            } else if met != 0 {
                link = node.links[first(&mut met)];
                while met != 0 {
                    stack[height] = node.links[first(&mut met)];
                    lanes.fetch_met(tree, stack[height]);
                    height += 1;
                }
                continue;
            }
        }
        if height == 0 {
            return aside.is_some_and(is_hit);
        }
        height -= 1;
        link = stack[height];
    }
}

/// The same with a stack of its own.
#[cold]
#[inline(never)]
fn deeper_any<L: Lanes>(lanes: L, tree: &Tree, link: Link, ray: &Ray, within: Interval) -> bool {
    let seeker = Seeker::new(ray, within.min, tree);
    any(lanes, tree, link, &seeker, within.max)
}
