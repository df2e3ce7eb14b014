//! Octrees as students build them: what may be mistaken in each is of the caller's choice.

use crate::Graded;
use crate::cases::ch10_octree::octree_tree::{inner, leaf};
use crate::upon::changed;
use raybook::accel::octree::build::Limits;
use raybook::inside::octree::{build, child_cell};
use raybook::math::aabb::Aabb;
use raybook_workbook::exercises::ch05_box::Corners;
use raybook_workbook::exercises::ch10_octree::{OctreeBuild, reached};
use raybook_workbook::octree_rows::{NodeRow, TreeRow};
use std::collections::BTreeSet;

/// The tree that the library builds if it is told something else about which cells a box reaches, or other limits.
pub(super) fn built(
    q: &OctreeBuild,
    limits: impl FnOnce(Limits) -> Limits,
    seen: impl Fn(&Corners, &[Aabb; 8]) -> u8,
) -> TreeRow {
    let limits = limits(Limits {
        opening: q.opening,
        copies: q.copies,
        depth: q.depth.min(Limits::DEEPEST),
    });
    let bounds = Aabb {
        min: q.min,
        max: q.max,
    };
    let tree = build(bounds, q.shapes.len() as u32, limits, &|i, cells| {
        seen(&q.shapes[i as usize], cells)
    });
    TreeRow::from(tree)
}

/// The right tree, whose nodes with children, if `inner` is 1, or whose leaves, if it is 0, begin elsewhere: a node's row and all names tell where.
pub(super) fn begun(
    q: &OctreeBuild,
    inner: u32,
    first: impl Fn(&NodeRow, &[u32]) -> u32,
) -> TreeRow {
    let mut tree = OctreeBuild::right(q);
    for node in tree.nodes.iter_mut().filter(|node| node.inner == inner) {
        node.first = first(node, &tree.names);
    }
    tree
}

/// What is left of a limit on copies after a cut that makes some names of each shape.
pub(super) type Left = fn(copies: f32, made: f32) -> f32;

/// By which rule cells are cut.
#[derive(Clone, Copy)]
pub(super) struct Rule {
    /// Whether it pays to cut a cell with n shapes into these parts.
    pub(super) pays: fn(q: &OctreeBuild, n: f32, parts: &[Vec<u32>; 8]) -> bool,
    /// How many names the limit on copies allows to the parts of a cell with n shapes.
    pub(super) allowed: fn(copies: f32, n: f32) -> f32,
    /// What a cut leaves of the limit on copies for the parts.
    pub(super) left: Left,
    /// How many times the limits on depth and on copies are lowered for a child.
    pub(super) times: fn(child: u32) -> [u32; 2],
}

/// The tree by the right rule, but for what is changed.
pub(super) fn by(q: &OctreeBuild, change: impl FnOnce(&mut Rule)) -> TreeRow {
    let right = Rule {
        pays: |q, n, parts| q.opening + 0.25 * sum(parts) < n,
        allowed: |copies, n| copies * n,
        left: |copies, made| copies / made.max(1.0),
        times: |_| [1, 1],
    };
    let rule = changed(right, change);
    let mut tree = TreeRow {
        nodes: vec![leaf(0, 0)],
        names: Vec::new(),
    };
    let root = Aabb::new(q.min, q.max);
    let all = (0..q.shapes.len() as u32).collect();
    let limits = (q.depth.min(Limits::DEEPEST), q.copies);
    fill(q, &rule, &mut tree, (0, &root), all, limits);
    tree
}

/// The tree with another rule for what is left of the limit.
pub(super) fn with_limit(q: &OctreeBuild, left: Left) -> TreeRow {
    by(q, |rule| rule.left = left)
}

/// Σ nᵢ.
pub(super) fn sum(parts: &[Vec<u32>; 8]) -> f32 {
    parts.iter().map(Vec::len).sum::<usize>() as f32
}

/// A tree of more nodes is not cut further: a wrong rule might go on and on.
const MOST: usize = 1 << 16;

/// Builds what is below a node, of a cell with these shapes, within limits on depth and copies.
fn fill(
    q: &OctreeBuild,
    rule: &Rule,
    tree: &mut TreeRow,
    (node, cell): (usize, &Aabb),
    shapes: Vec<u32>,
    (depth, copies): (u32, f32),
) {
    let cells: [Aabb; 8] = std::array::from_fn(|i| child_cell(cell, i));
    let bits = |&shape: &u32| (shape, reached(&q.shapes[shape as usize], &cells));
    let bits: Vec<_> = shapes.iter().map(bits).collect();
    let parts: [Vec<u32>; 8] = std::array::from_fn(|i| {
        let inside = bits.iter().filter(|(_, bits)| bits >> i & 1 == 1);
        inside.map(|(shape, _)| *shape).collect()
    });
    let (before, after) = (shapes.len() as f32, sum(&parts));
    let pays = (rule.pays)(q, before, &parts);
    let is_full = tree.nodes.len() > MOST;
    if depth == 0 || !pays || after > (rule.allowed)(copies, before) || is_full {
        tree.nodes[node] = leaf(tree.names.len() as u32, shapes.len() as u32);
        tree.names.extend(shapes);
        return;
    }
    let first = tree.nodes.len();
    tree.nodes[node] = inner(first as u32);
    tree.nodes.extend((0..8).map(|_| leaf(0, 0)));
    for (i, part) in parts.into_iter().enumerate() {
        let [levels, times] = (rule.times)(i as u32);
        let left = (0..times).fold(copies, |left, _| (rule.left)(left, after / before));
        let limits = (depth.saturating_sub(levels), left);
        fill(q, rule, tree, (first + i, &cells[i]), part, limits);
    }
}

/// Writes the names of the shapes in a node anew, those of a node with children before its children's.
pub(super) fn name_all(tree: &TreeRow, node: usize, made: &mut TreeRow) {
    let row = &tree.nodes[node];
    let first = row.first as usize;
    let names = below(tree, node);
    if row.inner == 0 {
        made.nodes[node].first = made.names.len() as u32;
    }
    made.names.extend(names);
    if row.inner != 0 {
        (first..first + 8).for_each(|child| name_all(tree, child, made));
    }
}

/// Appends a node and all below it, each child behind all that is below the child before.
pub(super) fn depth_first(tree: &TreeRow, node: usize, made: &mut TreeRow) {
    let row = &tree.nodes[node];
    let first = row.first as usize;
    if row.inner == 0 {
        let names = &tree.names[first..first + row.count as usize];
        made.nodes.push(leaf(made.names.len() as u32, row.count));
        made.names.extend(names);
    } else {
        made.nodes.push(inner(made.nodes.len() as u32 + 1));
        (first..first + 8).for_each(|child| depth_first(tree, child, made));
    }
}

/// The shapes that the leaves below a node name.
fn below(tree: &TreeRow, node: usize) -> BTreeSet<u32> {
    let row = &tree.nodes[node];
    let first = row.first as usize;
    if row.inner == 0 {
        let names = &tree.names[first..first + row.count as usize];
        names.iter().copied().collect()
    } else {
        let children = first..first + 8;
        children.flat_map(|child| below(tree, child)).collect()
    }
}
