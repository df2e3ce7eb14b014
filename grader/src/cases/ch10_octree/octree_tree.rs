//! The tree of an answer to `octree_build`: its leaves, its cost, and whether each of its cuts pays.

use crate::Verdict;
use raybook::inside::octree::child_cell;
use raybook::math::aabb::Aabb;
use raybook_workbook::exercises::ch10_octree::{OctreeBuild, reached};
use raybook_workbook::octree_rows::{NodeRow, TreeRow};
use std::collections::BTreeSet;

/// A leaf of an answer.
struct LeafOf {
    node: usize,
    cell: Aabb,
    names: std::ops::Range<usize>,
}

/// What is wrong if a leaf's names are those of another leaf too.
fn shared(leaf: &LeafOf, leaves: &[LeafOf]) -> Option<String> {
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

/// The names of each leaf that has any, if the answer is a tree.
pub(super) fn names(
    q: &OctreeBuild,
    tree: &TreeRow,
) -> Result<Vec<std::ops::Range<usize>>, String> {
    let mut names: Vec<_> = leaves(q, tree)?
        .into_iter()
        .map(|leaf| leaf.names)
        .collect();
    names.retain(|names| !names.is_empty());
    Ok(names)
}

/// Whether an answer is a tree, and each of its leaves names the shapes that reach it, once, and no other.
///
/// # Errors
/// If it is not.
pub(super) fn is_tree(q: &OctreeBuild, tree: &TreeRow) -> Verdict {
    let leaves = leaves(q, tree)?;
    let tolerance = 1e-4 * (q.max - q.min).max_element();
    for leaf in &leaves {
        // Where its names begin is the cause of what they are.
        let or_shared = |why: String| Err(shared(leaf, &leaves).unwrap_or(why));
        let mut named = vec![0; q.shapes.len()];
        for &name in &tree.names[leaf.names.clone()] {
            named[name as usize] += 1;
        }
        for (i, (shape, named)) in q.shapes.iter().zip(named).enumerate() {
            let deep = (shape.max.min(leaf.cell.max) - shape.min.max(leaf.cell.min)).min_element();
            let node = leaf.node;
            if named > 1 {
                return or_shared(format!("leaf {node} names shape {i} twice"));
            }
            if named == 0 && deep > tolerance {
                return or_shared(format!(
                    "shape {i} reaches leaf {node}, which does not name it"
                ));
            }
            if named == 1 && deep < -tolerance {
                return or_shared(format!("leaf {node} names shape {i}, which is not in it"));
            }
        }
    }
    Ok(())
}

/// A way in which nodes may begin elsewhere.
struct Elsewhere {
    /// What is told of it.
    why: &'static str,
    /// Whether it is that of the nodes with children, or that of leaves that have names.
    inner: u32,
    /// Where a node begins that has this number and this row.
    first: fn(node: u32, row: &NodeRow) -> Option<u32>,
}

/// The ways that are tried, one after the other.
const ELSEWHERE: &[Elsewhere] = &[
    Elsewhere {
        why: "each leaf begins behind its last name in the list",
        inner: 0,
        first: |_, leaf| leaf.first.checked_sub(leaf.count),
    },
    Elsewhere {
        why: "each leaf begins one place too late in the list of names",
        inner: 0,
        first: |_, leaf| leaf.first.checked_sub(1),
    },
    Elsewhere {
        why: "each leaf has the place of its last name",
        inner: 0,
        first: |_, leaf| leaf.first.checked_add(1)?.checked_sub(leaf.count),
    },
    Elsewhere {
        why: "each node with children has the number of its last child",
        inner: 1,
        first: |_, node| node.first.checked_sub(7),
    },
    Elsewhere {
        why: "each node with children tells how far behind it its first child is",
        inner: 1,
        first: |i, node| node.first.checked_add(i),
    },
];

/// What is wrong with an answer that is a tree as soon as its leaves, or its nodes with children, begin elsewhere.
pub(super) fn misplaced(q: &OctreeBuild, tree: &TreeRow) -> Option<&'static str> {
    let is_tree_from = |inner: u32, first: &dyn Fn(u32, &NodeRow) -> Option<u32>| {
        let mut moved = tree.clone();
        for (i, node) in (0..).zip(&mut moved.nodes) {
            if node.inner == inner && (inner == 1 || node.count > 0) {
                let Some(first) = first(i, node) else {
                    return false;
                };
                node.first = first;
            }
        }
        is_tree(q, &moved).is_ok()
    };
    let way = ELSEWHERE
        .iter()
        .find(|way| is_tree_from(way.inner, &way.first));
    if let Some(way) = way {
        return Some(way.why);
    }
    let mut orders = [in_turn(tree), depth_first(q, tree)].into_iter();
    let begins = orders.find(|begins| is_tree_from(0, &|i, _| begins.get(i as usize).copied()))?;
    let begun = tree.nodes.iter().zip(&begins);
    let leaves = || {
        let begun = begun.clone();
        begun.filter(|(node, _)| node.inner == 0 && node.count > 0)
    };
    let name_at = |place: u32| tree.names.get(place as usize);
    Some(if leaves().all(|(leaf, _)| leaf.first == 0) {
        "each leaf begins at place 0 of the list of names"
    } else if leaves().all(|(leaf, begin)| name_at(*begin) == Some(&leaf.first)) {
        "each leaf has the number of its first shape, and not that name's place in the list"
    } else {
        "the names stand in the list leaf by leaf, and some leaf begins where the names of another are"
    })
}

/// Where the names of each node begin, if those of the leaves stand in the list as the leaves do.
fn in_turn(tree: &TreeRow) -> Vec<u32> {
    let ends = tree.nodes.iter().scan(0, |end: &mut u32, node| {
        let begin = *end;
        *end = end.saturating_add(if node.inner == 0 { node.count } else { 0 });
        Some(begin)
    });
    ends.collect()
}

/// The same, if they stand there in the order in which the leaves are met depth first; nothing if the answer is no tree.
fn depth_first(q: &OctreeBuild, tree: &TreeRow) -> Vec<u32> {
    let mut begun = tree.clone();
    for leaf in begun.nodes.iter_mut().filter(|node| node.inner == 0) {
        leaf.first = 0;
    }
    let leaves = leaves(q, &begun).unwrap_or_default();
    let (mut begins, mut end) = (vec![0; tree.nodes.len()], 0);
    // The last child comes first.
    for leaf in leaves.iter().rev() {
        begins[leaf.node] = end;
        end += leaf.names.len() as u32;
    }
    begins
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

/// The first node whose cut costs as much as the leaf would, by the shapes that the tree itself names below. In a cell whose corners and whose
/// opening are quarters, everybody's numbers are exact, and none is told elsewhere.
pub(super) fn cut_for_nothing(q: &OctreeBuild, tree: &TreeRow) -> Option<usize> {
    let is_quarters = |x: f32| x.abs() < 1e4 && (4.0 * x).fract() == 0.0;
    let numbers = [q.min.to_array(), q.max.to_array()].concat();
    if !numbers.into_iter().chain([q.opening]).all(is_quarters) {
        return None;
    }
    let below = |node: usize| named_below(tree, node).len() as f32;
    let costs_as_much = |node: &usize| {
        let row = &tree.nodes[*node];
        let first = row.first as usize;
        let parts = || (first..first + 8).map(below).sum::<f32>();
        row.inner == 1 && q.opening + 0.25 * parts() == below(*node)
    };
    (0..tree.nodes.len()).find(costs_as_much)
}

/// The shapes that the leaves below a node name.
fn named_below(tree: &TreeRow, node: usize) -> BTreeSet<u32> {
    let (mut names, mut to_do) = (BTreeSet::new(), vec![node]);
    while let Some(node) = to_do.pop() {
        let row = &tree.nodes[node];
        let first = row.first as usize;
        if row.inner == 0 {
            names.extend(tree.names.iter().skip(first).take(row.count as usize));
        } else {
            to_do.extend(first..first + 8);
        }
    }
    names
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
