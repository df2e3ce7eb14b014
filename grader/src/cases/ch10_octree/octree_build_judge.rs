//! The judge of `octree_build`: by what an octree must keep to and by its cost, not by its shape.

use raybook::accel::octree::tree::child_cell;
use crate::Verdict;
use raybook::math::aabb::Aabb;
use raybook_workbook::exercises::ch10_octree::OctreeBuild;
use raybook_workbook::octree_rows::{NodeRow, TreeRow};

/// Every shape in the leaves that it reaches and in no other, as few copies as asked for, and a cost like the reference's.
pub(super) fn judge(q: &OctreeBuild, golden: &TreeRow, got: &TreeRow) -> Verdict {
    let leaves = leaves(q, got)?;
    let tolerance = 1e-4 * (q.max - q.min).max_element();
    for leaf in &leaves {
        let names = &got.names[leaf.names.clone()];
        for (i, shape) in (0..).zip(&q.shapes) {
            let deep = (shape.max.min(leaf.cell.max) - shape.min.max(leaf.cell.min)).min_element();
            let named = names.iter().filter(|&&name| name == i).count();
            if named > 1 {
                return Err(format!("leaf {} names shape {i} twice", leaf.node));
            }
            if named == 0 && deep > tolerance {
                return Err(format!(
                    "shape {i} reaches leaf {}, which does not name it",
                    leaf.node
                ));
            }
            if named == 1 && deep < -tolerance {
                return Err(format!(
                    "leaf {} names shape {i}, which is not in it",
                    leaf.node
                ));
            }
        }
    }
    let (most, copies) = (q.copies * q.shapes.len() as f32, got.names.len() as f32);
    if copies > most.max(q.shapes.len() as f32) + 1e-3 {
        return Err(format!(
            "the leaves name {copies} shapes in all, and may name {most}"
        ));
    }
    // The golden tree is made by the same rules, so it can be taken apart too.
    let (cost, least) = (cost(q, got), cost(q, golden));
    if cost > 1.02 * least + 1e-3 {
        return Err(format!(
            "a ray through the cell is expected to cost {cost:.2} tests, and need not cost more than {least:.2}"
        ));
    }
    Ok(())
}

/// A leaf of an answer.
struct LeafOf {
    node: usize,
    cell: Aabb,
    names: std::ops::Range<usize>,
}

/// The leaves of an answer, if it is a tree and no deeper than it may be.
fn leaves(q: &OctreeBuild, tree: &TreeRow) -> Result<Vec<LeafOf>, String> {
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

/// The tests that a ray through the root is expected to cost: a node at depth d is entered by one ray of 4^d.
fn cost(q: &OctreeBuild, tree: &TreeRow) -> f32 {
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
