//! The tree of an answer to `octree_build`: its leaves, its cost, and whether each of its cuts pays.

use raybook::inside::octree::child_cell;
use raybook::math::aabb::Aabb;
use raybook_workbook::exercises::ch10_octree::{OctreeBuild, reached};
use raybook_workbook::octree_rows::{NodeRow, TreeRow};

/// A leaf of an answer.
pub(super) struct LeafOf {
    pub node: usize,
    pub cell: Aabb,
    pub names: std::ops::Range<usize>,
}

/// What is wrong if a leaf's names are those of another leaf too.
pub(super) fn shared(leaf: &LeafOf, leaves: &[LeafOf]) -> Option<String> {
    let shares = |other: &&LeafOf| {
        let (a, b) = (&leaf.names, &other.names);
        other.node != leaf.node && a.start < b.end && b.start < a.end
    };
    let other = leaves.iter().find(shares)?;
    let at = leaf.names.start.max(other.names.start);
    Some(format!(
        "leaves {} and {} both name what is at place {at} of the list of names",
        leaf.node, other.node
    ))
}

/// The leaves of an answer, if it is a tree and no deeper than it may be.
pub(super) fn leaves(q: &OctreeBuild, tree: &TreeRow) -> Result<Vec<LeafOf>, String> {
    let root = Aabb {
        min: q.min,
        max: q.max,
    };
    let (mut leaves, mut seen) = (Vec::new(), vec![false; tree.nodes.len()]);
    let mut to_do = vec![(0_usize, root, 0)];
    while let Some((node, cell, depth)) = to_do.pop() {
        let Some(row) = tree.nodes.get(node) else {
            return Err(format!(
                "there is no node {node}; there are {}",
                tree.nodes.len()
            ));
        };
        if std::mem::replace(&mut seen[node], true) {
            return Err(format!("node {node} is the child of two nodes"));
        }
        if row.inner > 1 || (row.inner == 1 && row.count > 0) {
            return Err(format!(
                "node {node} is {} {} {}: a node with children is 1, its first child and 0, and a leaf begins with 0",
                row.inner, row.first, row.count
            ));
        }
        let first = row.first as usize;
        if row.inner == 0 {
            let names = first..first.saturating_add(row.count as usize);
            if names.end > tree.names.len() && !names.is_empty() {
                return Err(format!(
                    "leaf {node} names the shapes {first} to {} of a list of {}",
                    names.end,
                    tree.names.len()
                ));
            }
            let names = if names.is_empty() { 0..0 } else { names };
            leaves.push(LeafOf { node, cell, names });
        } else if depth == q.depth {
            return Err(format!(
                "node {node} is cut at depth {depth}, which is the limit"
            ));
        } else {
            to_do
                .extend((0..8).map(|i| (first.saturating_add(i), child_cell(&cell, i), depth + 1)));
        }
    }
    let shapes = q.shapes.len();
    match tree.names.iter().find(|&&name| name as usize >= shapes) {
        Some(name) => Err(format!(
            "there is no shape {name}; there are {shapes}, counted from 0"
        )),
        None => Ok(leaves),
    }
}

/// The first node that should have been cut, or should not, by the rule and within the limits.
pub(super) fn wrong_choice(q: &OctreeBuild, tree: &TreeRow) -> Option<String> {
    let root = Aabb {
        min: q.min,
        max: q.max,
    };
    let all: Vec<_> = (0..q.shapes.len()).collect();
    let mut to_do = vec![(0, root, all, q.copies, q.depth)];
    while let Some((node, cell, shapes, copies, depth)) = to_do.pop() {
        let cells: [Aabb; 8] = std::array::from_fn(|i| child_cell(&cell, i));
        let bits: Vec<_> = shapes
            .iter()
            .map(|&shape| reached(&q.shapes[shape], &cells))
            .collect();
        let (before, after) = (
            shapes.len() as f32,
            bits.iter().map(|bits| bits.count_ones()).sum::<u32>() as f32,
        );
        let gain = before - q.opening - 0.25 * after;
        let row = tree.nodes.get(node)?;
        if row.inner == 0 {
            if gain > 1e-3 && depth > 0 && after < copies * before * (1.0 - 1e-3) {
                return Some(format!("leaf {node} is not cut, and that would pay"));
            }
            continue;
        }
        if gain < -1e-3 {
            return Some(format!("node {node} is cut, and that does not pay"));
        }
        let left = copies / (after / before).max(1.0);
        for (i, cell) in cells.into_iter().enumerate() {
            let inside = shapes.iter().zip(&bits);
            let inside = inside.filter(|(_, bits)| *bits >> i & 1 != 0);
            let inside = inside.map(|(&shape, _)| shape).collect();
            to_do.push((
                row.first as usize + i,
                cell,
                inside,
                left,
                depth.saturating_sub(1),
            ));
        }
    }
    None
}

/// The tests that a ray through the root is expected to cost: a node at depth d is entered by one ray of 4^d.
pub(super) fn cost(q: &OctreeBuild, tree: &TreeRow) -> f32 {
    let mut cost = 0.0;
    let mut to_do = vec![(0, 1.0)];
    while let Some((node, share)) = to_do.pop() {
        let row: &NodeRow = &tree.nodes[node];
        if row.inner == 0 {
            cost += share * row.count as f32;
        } else {
            cost += share * q.opening;
            to_do.extend((0..8).map(|i| (row.first as usize + i, 0.25 * share)));
        }
    }
    cost
}

/// A leaf's row.
pub(super) fn leaf(first: u32, count: u32) -> NodeRow {
    NodeRow {
        inner: 0,
        first,
        count,
    }
}

/// The row of a node with children.
pub(super) fn inner(first: u32) -> NodeRow {
    NodeRow {
        inner: 1,
        first,
        count: 0,
    }
}
