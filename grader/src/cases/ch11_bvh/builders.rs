//! Trees of boxes by the surface-area heuristic, with settings, and what mistaken builders make of a tree.

use super::{area, around, center};
use crate::Graded;
use crate::upon::changed;
use raybook::math::aabb::Aabb;
use raybook_workbook::exercises::ch11_bvh::{BvhBuild, BvhBuildAnswer};
use raybook_workbook::tree_rows::NodeRow;
use std::ops::Range;

/// How a tree is built; one field wrong is a mistake.
#[derive(Clone, Copy)]
pub(super) struct How {
    /// The axes along which cuts are tried, `depth` cuts below the root.
    pub(super) axes: fn(q: &BvhBuild, which: &[u32], depth: usize) -> Range<usize>,
    /// Whether the boxes are sorted by their centres along an axis before they are cut.
    pub(super) is_sorted: bool,
    /// By which size a side of a cut costs something.
    pub(super) size: Size,
    /// The size of the right side.
    pub(super) right: fn(left: &Aabb, right: &Aabb, size: Size) -> f32,
    /// The number of boxes by which a side costs something.
    pub(super) count: fn(count: f32) -> f32,
    /// The cost of a cut by that of its sides.
    pub(super) sum: fn(left: f32, right: f32) -> f32,
    /// Of each place in a row, from 1 on, by what it is chosen: the least is, the first of several.
    pub(super) ranks: fn(row: &Row<'_>) -> Vec<f32>,
    /// The axis and the place of the cut, if these are chosen.
    pub(super) place: fn(q: &BvhBuild, which: &[u32], chosen: Place) -> Place,
    /// The area by which the cost of a cut is divided.
    pub(super) own: fn(q: &BvhBuild, which: &[u32]) -> f32,
    /// The cost of opening a branch.
    pub(super) opening: f32,
    /// Whether this number of boxes fit into a leaf of at most `most`.
    pub(super) fits: fn(count: usize, most: usize) -> bool,
    /// Whether boxes that fit into a leaf become one.
    pub(super) is_leaf: fn(is_cheaper: bool) -> bool,
    /// The same tree with its nodes as they are numbered.
    pub(super) numbered: fn(tree: BvhBuildAnswer) -> BvhBuildAnswer,
}

/// An axis, and a place in the row along it.
type Place = (usize, usize);

/// A box's size.
pub(super) type Size = fn(around: &Aabb) -> f32;

/// A node's boxes in a row.
pub(super) struct Row<'a> {
    pub(super) q: &'a BvhBuild,
    pub(super) order: Vec<u32>,
    /// The axis along which the row is cut.
    pub(super) axis: usize,
    /// What a cut costs at each place, from 1 on.
    pub(super) costs: Vec<f32>,
}

/// As it should be: the cheapest cut of all, and a leaf where it costs no more than the branch and the cut.
const WELL: How = How {
    axes: |_, _, _| 0..3,
    is_sorted: true,
    size: |around| area(around.min, around.max),
    right: |_, right, size| size(right),
    count: |count| count,
    sum: |left, right| left + right,
    ranks: |row| row.costs.clone(),
    place: |_, _, chosen| chosen,
    own: area_around,
    opening: 1.0,
    fits: |count, most| count <= most,
    is_leaf: |is_cheaper| is_cheaper,
    numbered: |tree| tree,
};

/// The tree, built rightly but for what is changed.
pub(super) fn built(q: &BvhBuild, change: impl FnOnce(&mut How)) -> BvhBuildAnswer {
    tree(q, &changed(WELL, change))
}

/// The same, where all that a leaf can hold becomes one.
pub(super) fn of_full_leaves(q: &BvhBuild, change: impl FnOnce(&mut How)) -> BvhBuildAnswer {
    built(q, |how| {
        change(how);
        how.is_leaf = |_| true;
    })
}

/// The tree as it should be, for the judge: by the cheapest of all cuts.
pub(super) fn by_all_cuts(q: &BvhBuild) -> BvhBuildAnswer {
    tree(q, &WELL)
}

fn tree(q: &BvhBuild, how: &How) -> BvhBuildAnswer {
    let node = |which: &[u32]| {
        let Aabb { min, max } = around(&q.boxes, which);
        NodeRow {
            min,
            max,
            first: 0,
            count: 0,
        }
    };
    let all: Vec<_> = (0..q.boxes.len() as u32).collect();
    let mut tree = BvhBuildAnswer {
        nodes: vec![node(&all)],
        order: Vec::new(),
    };
    let mut open = vec![(0, all, 0)];
    while let Some((at, which, depth)) = open.pop() {
        let cut = cut(q, how, &which, depth).filter(|(_, cost)| {
            let own = (how.own)(q, &which);
            let is_cheaper = how.opening * own + cost >= own * which.len() as f32;
            !((how.fits)(which.len(), q.most.max(1) as usize) && (how.is_leaf)(is_cheaper))
        });
        let Some((sides, _)) = cut else {
            tree.nodes[at].first = tree.order.len() as u32;
            tree.nodes[at].count = which.len() as u32;
            tree.order.extend(which);
            continue;
        };
        tree.nodes[at].first = tree.nodes.len() as u32;
        for side in sides {
            open.push((tree.nodes.len(), side.clone(), depth + 1));
            tree.nodes.push(node(&side));
        }
    }
    (how.numbered)(tree)
}

/// The two sides of a node's boxes, and what is taken for the cost of the cut; none of less than two boxes.
fn cut(q: &BvhBuild, how: &How, which: &[u32], depth: usize) -> Option<([Vec<u32>; 2], f32)> {
    let mut best: Option<(f32, f32, Place)> = None;
    for axis in (how.axes)(q, which, depth) {
        let row = row(q, how, which, axis);
        let places = (1..).zip((how.ranks)(&row).into_iter().zip(row.costs));
        for (at, (rank, cost)) in places {
            if best.is_none_or(|(least, ..)| rank < least) {
                best = Some((rank, cost, (axis, at)));
            }
        }
    }
    let (_, cost, chosen) = best?;
    let (axis, at) = (how.place)(q, which, chosen);
    let mut left = sorted(q, how, which, axis);
    let right = left.split_off(at);
    Some(([left, right], cost))
}

/// The boxes in the order of their centres along an axis, or as they are.
fn sorted(q: &BvhBuild, how: &How, which: &[u32], axis: usize) -> Vec<u32> {
    let mut sorted = which.to_vec();
    if how.is_sorted {
        let place = |&i: &u32| center(&q.boxes[i as usize])[axis];
        sorted.sort_by(|a, b| place(a).total_cmp(&place(b)));
    }
    sorted
}

/// A row along an axis. The costs are found in one sweep: some rules make as many branches as there are boxes, and look at all boxes below in each.
fn row<'a>(q: &'a BvhBuild, how: &How, which: &[u32], axis: usize) -> Row<'a> {
    let order = sorted(q, how, which, axis);
    let all = order.len();
    let cost = |(at, [left, right]): (usize, [Aabb; 2])| {
        let of_left = (how.size)(&left) * (how.count)(at as f32);
        let of_right = (how.right)(&left, &right, how.size) * (how.count)((all - at) as f32);
        (how.sum)(of_left, of_right)
    };
    let costs = (1..).zip(sides(q, &order)).map(cost).collect();
    Row {
        q,
        order,
        axis,
        costs,
    }
}

/// The boxes around both sides of each place in a row, from 1 on.
fn sides(q: &BvhBuild, row: &[u32]) -> Vec<[Aabb; 2]> {
    let grow = |around: &mut Aabb, i: &u32| {
        *around = around.union(&Aabb::from(&q.boxes[*i as usize]));
        Some(*around)
    };
    let left = row.iter().scan(Aabb::EMPTY, grow);
    let mut right: Vec<_> = row.iter().rev().scan(Aabb::EMPTY, grow).collect();
    right.reverse();
    let behind = right.into_iter().skip(1);
    left.zip(behind)
        .map(|(left, right)| [left, right])
        .collect()
}

/// The area of the box around some boxes.
pub(super) fn area_around(q: &BvhBuild, which: &[u32]) -> f32 {
    let Aabb { min, max } = around(&q.boxes, which);
    area(min, max)
}

/// The box around the centres of some boxes.
pub(super) fn around_centers(q: &BvhBuild, which: &[u32]) -> Aabb {
    Aabb::of(which.iter().map(|&i| center(&q.boxes[i as usize])))
}

/// The same tree, in which the box of each node is made anew of the boxes below.
pub(super) fn with_boxes(
    q: &BvhBuild,
    mut tree: BvhBuildAnswer,
    of: fn(q: &BvhBuild, which: &[u32]) -> Aabb,
) -> BvhBuildAnswer {
    let around = |node: usize| of(q, &below(&tree, node));
    let boxes: Vec<_> = (0..tree.nodes.len()).map(around).collect();
    for (node, around) in tree.nodes.iter_mut().zip(boxes) {
        (node.min, node.max) = (around.min, around.max);
    }
    tree
}

/// The boxes in the leaves below a node, as far as it is one of a tree.
fn below(tree: &BvhBuildAnswer, node: usize) -> Vec<u32> {
    let (mut which, mut to_do) = (Vec::new(), vec![node]);
    for _ in 0..tree.nodes.len() {
        let Some(row) = to_do.pop().and_then(|node| tree.nodes.get(node)) else {
            break;
        };
        let first = row.first as usize;
        if row.count > 0 {
            which.extend(tree.order.iter().skip(first).take(row.count as usize));
        } else {
            to_do.extend([first, first.saturating_add(1)]);
        }
    }
    which
}

/// The axis along which a box is longest.
pub(super) fn longest(bounds: &Aabb) -> Range<usize> {
    let axis = bounds.size().max_position();
    axis..axis + 1
}

/// The axis along which the node's box is longest.
pub(super) fn along_the_longest(q: &BvhBuild, which: &[u32], _: usize) -> Range<usize> {
    longest(&around(&q.boxes, which))
}

/// Ranks by which the dearest cut is chosen.
pub(super) fn dearest(row: &Row<'_>) -> Vec<f32> {
    row.costs.iter().map(|cost| -cost).collect()
}

/// Ranks by which only this place is chosen.
pub(super) fn only(row: &Row<'_>, place: usize) -> Vec<f32> {
    let rank = |at| f32::from(at != place);
    (1..row.order.len()).map(rank).collect()
}

/// Ranks by which the boxes whose centres are below the middle of a box are on the left, or half of all boxes where a side would be empty.
pub(super) fn halved(row: &Row<'_>, bounds: &Aabb) -> Vec<f32> {
    let middle = bounds.center()[row.axis];
    let is_left = |i: &&u32| center(&row.q.boxes[**i as usize])[row.axis] < middle;
    let (left, all) = (row.order.iter().filter(is_left).count(), row.order.len());
    let is_empty = left == 0 || left == all;
    only(row, if is_empty { all / 2 } else { left })
}

/// Ranks by which the gap between neighbouring centres is widest.
pub(super) fn gaps(row: &Row<'_>) -> Vec<f32> {
    let place = |i: u32| center(&row.q.boxes[i as usize])[row.axis];
    let gaps = row
        .order
        .windows(2)
        .map(|two| place(two[0]) - place(two[1]));
    gaps.collect()
}

/// Ranks by which the space between the boxes before and those behind is widest, or where all of these overlap, they do so least.
pub(super) fn spaces(row: &Row<'_>) -> Vec<f32> {
    let overlap = |[left, right]: [Aabb; 2]| left.max[row.axis] - right.min[row.axis];
    sides(row.q, &row.order).into_iter().map(overlap).collect()
}

/// The right tree, but for where its leaves begin.
pub(super) fn with_first(q: &BvhBuild, first: fn(first: u32, count: u32) -> u32) -> BvhBuildAnswer {
    let mut tree = BvhBuild::right(q);
    for leaf in tree.nodes.iter_mut().filter(|node| node.count > 0) {
        leaf.first = first(leaf.first, leaf.count);
    }
    tree
}

/// The right tree with its nodes row by row, each branch with the number after its own for that of its first child.
pub(super) fn with_numbers_after_own(q: &BvhBuild) -> BvhBuildAnswer {
    let mut tree = BvhBuild::canonical(q, BvhBuild::right(q));
    for (own, node) in (0..).zip(&mut tree.nodes) {
        // The root of nothing is no branch, although it has no boxes.
        if node.count == 0 && !tree.order.is_empty() {
            node.first = own + 1;
        }
    }
    tree
}

/// The same tree with its nodes depth first, each branch with the number of its first child, 0, or of its second, 1.
pub(super) fn depth_first(tree: &BvhBuildAnswer, child: usize) -> BvhBuildAnswer {
    let mut made = BvhBuildAnswer {
        nodes: Vec::new(),
        order: Vec::new(),
    };
    // The root of nothing is no branch, although it has no boxes.
    if !tree.order.is_empty() {
        append(tree, 0, child, &mut made);
    }
    made
}

/// Appends a node and all below it.
fn append(tree: &BvhBuildAnswer, node: usize, child: usize, made: &mut BvhBuildAnswer) {
    let row = &tree.nodes[node];
    let (first, count) = (row.first as usize, row.count as usize);
    let own = made.nodes.len();
    made.nodes.push(row.clone());
    if count > 0 {
        made.nodes[own].first = made.order.len() as u32;
        made.order.extend(&tree.order[first..first + count]);
        return;
    }
    for below in 0..2 {
        if below == child {
            made.nodes[own].first = made.nodes.len() as u32;
        }
        append(tree, first + below, child, made);
    }
}
