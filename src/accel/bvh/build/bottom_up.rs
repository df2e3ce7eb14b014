//! Stage 2, bottom-up: merge neighbours until one tree is left (Meister and Bittner, "Parallel locally-ordered clustering for
//! bounding volume hierarchy construction", 2018).

use crate::accel::bvh::build::cost::Cost;
use crate::accel::bvh::build::flat::Flat;
use crate::accel::bvh::build::item::{Bounds, Extent, Item};
use crate::accel::bvh::build::tree::{Inside, MAX_DEPTH, Tree, halvings};
use crate::threads;
use glam::Vec3A;

/// A subtree looks for a partner among this many subtrees before it on the curve, and as many after it.
const RADIUS: usize = 14;

/// Builds a tree over the items.
///
/// The items are ordered along a curve on which neighbours in space are mostly near each other. Each item starts as a
/// subtree of its own. In each round, every subtree looks for a partner among the subtrees near it on the curve: the one with
/// which its common box is smallest. Two subtrees that choose each other are merged, in the place of the first.
pub(super) fn build(mut items: Vec<Item>, cost: &Cost) -> Flat {
    sort_along_curve(&mut items);
    let mut trees: Vec<_> = items.iter().map(single).collect();
    let mut levels = MAX_DEPTH;
    while trees.len() > 1 {
        levels -= 1;
        let mut partners = partners(&trees);
        let merges = (0..trees.len())
            .filter(|&i| partners[partners[i]] == i)
            .count()
            / 2;
        if halvings(trees.len() - merges) > levels {
            // The levels that are left only suffice for halving: every subtree merges with its neighbour.
            partners = (0..trees.len())
                .map(|i| (i ^ 1).min(trees.len() - 1))
                .collect();
        }
        trees = merge(trees, &partners);
    }
    let Some(sprout) = trees.pop() else {
        return Flat::new(&EMPTY, Vec::new());
    };
    let mut order = Vec::with_capacity(items.len());
    let (tree, _) = gather(sprout, cost, &mut order);
    Flat::new(&tree, order)
}

const EMPTY: Tree = Tree {
    bounds: Bounds::EMPTY,
    inside: Inside::Leaf(0),
};

/// The leaf of one item. While trees grow, [`Inside::Leaf`] holds the number of the shape, not the count of shapes.
fn single(item: &Item) -> Tree {
    Tree {
        bounds: item.bounds,
        inside: Inside::Leaf(item.index),
    }
}

/// For each subtree, the partner: the subtree within [`RADIUS`] with which its common box has the smallest surface.
///
/// Of equally good ones, `i ^ 1` is chosen if it is among them, else the first. So in every round at least two subtrees choose
/// each other, and equal boxes merge in pairs, all in one round.
fn partners(trees: &[Tree]) -> Vec<usize> {
    let of = |i: usize| {
        let (from, to) = (i.saturating_sub(RADIUS), (i + RADIUS + 1).min(trees.len()));
        let mut best = (f32::INFINITY, i);
        for j in std::iter::once(i ^ 1).chain(from..i).chain(i + 1..to) {
            let Some(other) = trees.get(j) else { continue };
            let area = trees[i].bounds.union(&other.bounds).half_area();
            if area < best.0 {
                best = (area, j);
            }
        }
        best.1
    };
    threads::list(trees.len(), of)
}

/// Merges all pairs of subtrees that are each other's partners; the others stay as they are.
fn merge(mut trees: Vec<Tree>, partners: &[usize]) -> Vec<Tree> {
    let mut merged = Vec::with_capacity(trees.len());
    for (i, &j) in partners.iter().enumerate() {
        let mutual = i != j && partners[j] == i;
        if mutual && j < i {
            continue; // it has been merged with its partner
        }
        let tree = std::mem::replace(&mut trees[i], EMPTY);
        merged.push(if mutual {
            let other = std::mem::replace(&mut trees[j], EMPTY);
            Tree {
                bounds: tree.bounds.union(&other.bounds),
                inside: Inside::Branch(Box::new([tree, other])),
            }
        } else {
            tree
        });
    }
    merged
}

/// Turns every subtree that costs no more as a leaf into a leaf, and appends the numbers of its shapes to `order`; returns
/// the subtree and its cost: the sum over its nodes of half the surface area times the price.
fn gather(tree: Tree, cost: &Cost, order: &mut Vec<u32>) -> (Tree, f32) {
    let (bounds, area, start) = (tree.bounds, tree.bounds.half_area(), order.len());
    let (inside, below) = match tree.inside {
        Inside::Leaf(index) => {
            order.push(index);
            (Inside::Leaf(1), f32::INFINITY)
        }
        Inside::Branch(children) => {
            let [(left, a), (right, b)] = children.map(|child| gather(child, cost, order));
            let below = cost.branch * area + a + b;
            (Inside::Branch(Box::new([left, right])), below)
        }
    };
    let count = order.len() - start;
    let as_leaf = area * cost.shapes(count);
    if count <= cost.most as usize && as_leaf <= below {
        let inside = Inside::Leaf(count as u32);
        (Tree { bounds, inside }, as_leaf)
    } else {
        (Tree { bounds, inside }, below)
    }
}

/// Sorts the items by the Morton codes of their centres (Morton 1966): 21 bits per axis, interleaved.
fn sort_along_curve(items: &mut [Item]) {
    let centers2 = Extent::of(items).centers2;
    let size = (centers2.max - centers2.min).max(Vec3A::splat(f32::MIN_POSITIVE));
    let code = |item: &Item| {
        let at = (item.center2() - centers2.min) / size * ((1 << 21) - 1) as f32;
        let [x, y, z] = at.to_array().map(|at| spread(at as u64));
        x << 2 | y << 1 | z
    };
    threads::sort_by_cached_key(items, code);
}

/// Moves each of the lowest 21 bits, bit i, to place 3·i.
fn spread(bits: u64) -> u64 {
    const STEPS: [(u32, u64); 5] = [
        (32, 0x001f_0000_0000_ffff),
        (16, 0x001f_0000_ff00_00ff),
        (8, 0x100f_00f0_0f00_f00f),
        (4, 0x10c3_0c30_c30c_30c3),
        (2, 0x1249_2492_4924_9249),
    ];
    STEPS
        .iter()
        .fold(bits, |bits, (by, mask)| (bits | bits << by) & mask)
}
