//! Walks through an octree, as students mistake them, and trees as they misread them.

use crate::Graded;
use glam::Vec3;
use raybook::inside::octree::child_cell;
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

/// The same, from the bits themselves.
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
