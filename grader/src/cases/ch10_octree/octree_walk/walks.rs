//! Walks through an octree, as students mistake them, and trees as they misread them.

use crate::Graded;
use glam::Vec3;
use raybook::inside::octree::{child_at, child_cell};
use raybook::math::{aabb::Aabb, interval::Interval, ray::Ray, slab};
use raybook_workbook::exercises::ch10_octree::OctreeWalk;
use raybook_workbook::octree_rows::NodeRow;

/// The leaf to which a walk comes that never goes back to another child.
pub(super) fn nearest_only(q: &OctreeWalk) -> Vec<u32> {
    let bounds = Aabb {
        min: q.min,
        max: q.max,
    };
    let (mut node, mut cell) = (0, bounds);
    loop {
        let row = &q.nodes[node as usize];
        if row.inner == 0 {
            return if row.count > 0 {
                vec![node]
            } else {
                Vec::new()
            };
        }
        let children = (0..8).map(|child| (child, child_cell(&cell, child)));
        let stays = children.filter_map(|(child, cell)| {
            let inside = slab::clip(&cell, &q.ray, q.within)?;
            (inside.max > inside.min).then_some((inside.min + inside.max, child, cell))
        });
        let Some((_, child, below)) = stays.min_by(|a, b| a.0.total_cmp(&b.0)) else {
            return Vec::new();
        };
        (node, cell) = (row.first + child as u32, below);
    }
}

pub(super) fn walked(q: &OctreeWalk, ray: Ray, within: Interval) -> Vec<u32> {
    OctreeWalk::right(&OctreeWalk {
        ray,
        within,
        ..q.clone()
    })
}

/// The right leaves in the order of a walk that turns other bits of the children's numbers.
pub(super) fn ordered(q: &OctreeWalk, turned: fn([f32; 3]) -> u32) -> Vec<u32> {
    in_turn(q, turned(q.ray.direction.to_array()))
}

/// The bits of the axes along which the ray moves down: those that are rightly turned.
pub(super) fn down(direction: [f32; 3]) -> u32 {
    let bits = direction.map(|d| u32::from(d < 0.0));
    bits[0] | bits[1] << 1 | bits[2] << 2
}

/// The same as [`ordered`], from the bits themselves.
pub(super) fn in_turn(q: &OctreeWalk, turned: u32) -> Vec<u32> {
    let right = OctreeWalk::right(q);
    let mut found = Vec::new();
    below(q, 0, turned, &mut |node| {
        if right.contains(&node) {
            found.push(node);
        }
    });
    found
}

/// The number of the root's child in which a point lies; of the nearest one, for a point outside.
pub(super) fn octant(q: &OctreeWalk, p: Vec3) -> u32 {
    p.cmpgt(0.5 * (q.min + q.max)).bitmask()
}

/// The bits of the axes along which a direction goes down.
pub(super) fn mirror(d: [f32; 3]) -> u32 {
    (0..3).map(|axis| u32::from(d[axis] < 0.0) << axis).sum()
}

/// Visits a node and all below it, the children in the order of their numbers with some bits turned.
pub(super) fn below(q: &OctreeWalk, node: u32, turned: u32, visit: &mut dyn FnMut(u32)) {
    visit(node);
    let NodeRow { inner, first, .. } = q.nodes[node as usize];
    if inner == 1 {
        for i in 0..8 {
            below(q, first + (i ^ turned), turned, visit);
        }
    }
}

/// Gives each empty leaf a shape.
pub(super) fn fill_empty_leaves(q: &mut OctreeWalk) {
    let empty = |node: &&mut NodeRow| node.inner == 0 && node.count == 0;
    let leaves = q.nodes.iter_mut().filter(empty);
    leaves.for_each(|node| node.count = 1);
}

/// The leaves on the ray's way, front to back, if child i of a node has another number: from the node's own, and the first child's.
pub(super) fn numbered(q: &OctreeWalk, number: fn(u32, u32, u32) -> u32) -> Vec<u32> {
    let mut stays = Vec::new();
    let mut open = vec![(0, Aabb::new(q.min, q.max), 0)];
    while let Some((node, cell, depth)) = open.pop() {
        let Some(&NodeRow {
            inner,
            first,
            count,
        }) = q.nodes.get(node as usize)
        else {
            continue;
        };
        let stay = slab::clip(&cell, &q.ray, q.within).filter(|stay| stay.max > stay.min);
        let Some(stay) = stay.filter(|_| depth < q.nodes.len()) else {
            continue;
        };
        if inner == 1 {
            let child = |i: u32| {
                (
                    number(node, first, i),
                    child_cell(&cell, i as usize),
                    depth + 1,
                )
            };
            open.extend((0..8).map(child));
        } else if count > 0 {
            stays.push((stay.min + stay.max, node));
        }
    }
    stays.sort_by(|a, b| a.0.total_cmp(&b.0));
    stays.into_iter().map(|(_, node)| node).collect()
}

/// The number of nodes above each node.
pub(super) fn levels(q: &OctreeWalk) -> Vec<u32> {
    let mut levels = vec![0; q.nodes.len()];
    for node in 0..q.nodes.len() {
        let NodeRow { inner, first, .. } = q.nodes[node];
        if inner == 1 {
            let below = levels[node] + 1;
            levels[first as usize..][..8].fill(below);
        }
    }
    levels
}

/// The leaves of a walk that opens of each node only the child at either end of the ray's stay.
pub(super) fn ends_only(q: &OctreeWalk) -> Vec<u32> {
    let mut found = Vec::new();
    let mut open = vec![(0, Aabb::new(q.min, q.max))];
    while let Some((node, cell)) = open.pop() {
        let NodeRow {
            inner,
            first,
            count,
        } = q.nodes[node as usize];
        let stay = slab::clip(&cell, &q.ray, q.within).filter(|stay| stay.max > stay.min);
        let Some(stay) = stay else {
            continue;
        };
        if inner == 1 {
            // A little inside, for on a face rounding would decide.
            let ends = [1e-4, 1.0 - 1e-4].map(|part| {
                let t = stay.min + part * (stay.max - stay.min);
                child_at(&cell, q.ray.at(t))
            });
            let child = |i: usize| (first + i as u32, child_cell(&cell, i));
            // That taken from the stack first is put there last.
            open.extend((ends[1] != ends[0]).then(|| child(ends[1])));
            open.push(child(ends[0]));
        } else if count > 0 {
            found.push(node);
        }
    }
    found
}

/// The children of a node in the order in which the ray may meet them, and whether it does.
pub(super) type Children<'a> = &'a [(u32, bool)];

/// Those that the ray meets.
pub(super) fn met(children: Children<'_>) -> impl Iterator<Item = u32> {
    let met = children.iter().filter(|(_, is_met)| *is_met);
    met.map(|(child, _)| *child)
}

/// The place of the first that it misses.
pub(super) fn missed(children: Children<'_>) -> usize {
    let first = children.iter().position(|(_, is_met)| !is_met);
    first.unwrap_or(children.len())
}

/// The leaves of a walk that opens these children of each node.
pub(super) fn chosen(q: &OctreeWalk, choose: fn(Children<'_>) -> Vec<u32>) -> Vec<u32> {
    let mut found = Vec::new();
    let root = (0, Aabb::new(q.min, q.max));
    descend(q, root, &child_cell, &choose, &mut found);
    found
}

/// Lists the leaves below a node and its cell, with these cells of its children, of which these are opened.
pub(super) fn descend(
    q: &OctreeWalk,
    (node, cell): (u32, Aabb),
    cell_of: &dyn Fn(&Aabb, usize) -> Aabb,
    choose: &dyn Fn(Children<'_>) -> Vec<u32>,
    found: &mut Vec<u32>,
) {
    let NodeRow {
        inner,
        first,
        count,
    } = q.nodes[node as usize];
    let is_met = |cell: &Aabb| {
        let stay = slab::clip(cell, &q.ray, q.within);
        stay.is_some_and(|stay| stay.max > stay.min)
    };
    if !is_met(&cell) {
        return;
    }
    if inner == 1 {
        let turned = mirror(q.ray.direction.to_array());
        let children = (0..8).map(|i| i ^ turned);
        let children: Vec<_> = children
            .map(|i| (i, is_met(&cell_of(&cell, i as usize))))
            .collect();
        for i in choose(&children) {
            let child = (first + i, cell_of(&cell, i as usize));
            descend(q, child, cell_of, choose, found);
        }
    } else if count > 0 {
        found.push(node);
    }
}
