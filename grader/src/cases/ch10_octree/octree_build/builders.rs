//! Octrees as students build them: what may be mistaken in each is of the caller's choice.

use crate::Graded;
use crate::cases::ch10_octree::octree_tree::{inner, leaf};
use crate::upon::changed;
use raybook::accel::octree::build::Limits;
use raybook::inside::octree::child_cell;
use raybook::math::aabb::Aabb;
use raybook_workbook::exercises::ch05_box::Corners;
use raybook_workbook::exercises::ch10_octree::{OctreeBuild, reached};
use raybook_workbook::octree_rows::{NodeRow, TreeRow};
use std::collections::BTreeSet;

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

/// How a tree is built; one field wrong is a mistake.
#[derive(Clone, Copy)]
pub(super) struct How {
    /// Where a shape is looked for.
    pub(super) place: fn(shape: &Corners) -> Corners,
    /// The boxes with which a shape is compared, of a cell's children; `of_root` are those of the root.
    pub(super) cells: fn(cells: [Aabb; 8], of_root: [Aabb; 8]) -> [Aabb; 8],
    /// In which of the children that it reaches a shape is named, one bit each.
    pub(super) kept: fn(bits: u8) -> u8,
    /// How many tests a ray is expected to make in the children of a cell, among which its shapes are parted.
    pub(super) expected: fn(parts: &[Vec<u32>; 8]) -> f32,
    /// How often the cost of opening is paid.
    pub(super) openings: f32,
    /// What a cut must cost less than, of a cell with `n` shapes.
    pub(super) compared: fn(q: &OctreeBuild, n: f32) -> f32,
    /// Whether a cut of some cost is made, of a cell that costs as much without.
    pub(super) is_cheaper: fn(cut: f32, whole: f32) -> bool,
    /// A cell with more shapes than these is cut if that pays.
    pub(super) more_than: f32,
    /// Whether a cut that costs less is made, of a cell with `n` shapes.
    pub(super) may_pay: fn(n: f32, parts: &[Vec<u32>; 8]) -> bool,
    /// How many names the limit on copies allows to the parts of a cell with `n` shapes.
    pub(super) allowed: fn(q: &OctreeBuild, copies: f32, n: f32) -> f32,
    /// What is left of the limit on copies after a cut that makes some names of each shape.
    pub(super) left: fn(copies: f32, made: f32) -> f32,
    /// How many times the limits on depth and on copies are lowered for a child.
    pub(super) times: fn(child: u32) -> [u32; 2],
}

/// As it should be.
const WELL: How = How {
    place: Corners::clone,
    cells: |cells, _| cells,
    kept: |bits| bits,
    expected: |parts| 0.25 * sum(parts),
    openings: 1.0,
    compared: |_, n| n,
    is_cheaper: |cut, whole| cut < whole,
    more_than: f32::NEG_INFINITY,
    may_pay: |_, _| true,
    allowed: |_, copies, n| copies * n,
    left: |copies, made| copies / made.max(1.0),
    times: |_| [1, 1],
};

/// The tree, built rightly but for what is changed.
pub(super) fn built(q: &OctreeBuild, change: fn(&mut How)) -> TreeRow {
    let how = changed(WELL, change);
    let mut tree = TreeRow {
        nodes: vec![leaf(0, 0)],
        names: Vec::new(),
    };
    let root = Aabb::new(q.min, q.max);
    let all = (0..q.shapes.len() as u32).collect();
    let limits = (q.depth.min(Limits::DEEPEST), q.copies);
    fill(q, &how, &mut tree, (0, &root), all, limits);
    tree
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
    how: &How,
    tree: &mut TreeRow,
    (node, cell): (usize, &Aabb),
    shapes: Vec<u32>,
    (depth, copies): (u32, f32),
) {
    let of_cell = |cell: &Aabb| std::array::from_fn(|i| child_cell(cell, i));
    let cells: [Aabb; 8] = of_cell(cell);
    let compared = (how.cells)(cells, of_cell(&Aabb::new(q.min, q.max)));
    let bits = |&shape: &u32| {
        let place = (how.place)(&q.shapes[shape as usize]);
        (shape, (how.kept)(reached(&place, &compared)))
    };
    let bits: Vec<_> = shapes.iter().map(bits).collect();
    let parts: [Vec<u32>; 8] = std::array::from_fn(|i| {
        let inside = bits.iter().filter(|(_, bits)| bits >> i & 1 == 1);
        inside.map(|(shape, _)| *shape).collect()
    });
    let (before, after) = (shapes.len() as f32, sum(&parts));
    let cost = how.openings * q.opening + (how.expected)(&parts);
    let is_cheaper = (how.is_cheaper)(cost, (how.compared)(q, before));
    let pays = is_cheaper && before > how.more_than && (how.may_pay)(before, &parts);
    let is_full = tree.nodes.len() > MOST;
    if depth == 0 || !pays || after > (how.allowed)(q, copies, before) || is_full {
        tree.nodes[node] = leaf(tree.names.len() as u32, shapes.len() as u32);
        tree.names.extend(shapes);
        return;
    }
    let first = tree.nodes.len();
    tree.nodes[node] = inner(first as u32);
    tree.nodes.extend((0..8).map(|_| leaf(0, 0)));
    for (i, part) in parts.into_iter().enumerate() {
        let [levels, times] = (how.times)(i as u32);
        let left = (0..times).fold(copies, |left, _| (how.left)(left, after / before));
        let limits = (depth.saturating_sub(levels), left);
        fill(q, how, tree, (first + i, &cells[i]), part, limits);
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
