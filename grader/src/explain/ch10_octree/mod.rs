//! Chapter 10: the child of a point, the octree that is worth its price, and the leaves on a ray's way.

mod build;
mod child;
mod walk;

use raybook::inside::octree::child_cell;
use raybook::math::aabb::Aabb;
use raybook_workbook::octree_rows::NodeRow;

/// More rectangles than these nobody can tell apart.
pub const MOST: usize = 400;

/// The leaves of a list of nodes with their cells. A list of a student's may hold anything: a child that does not come after its
/// parent is left out.
pub fn leaves(root: Aabb, nodes: &[NodeRow]) -> Vec<(usize, Aabb)> {
    let (mut found, mut to_do) = (Vec::new(), vec![(0, root)]);
    // Each node has one parent, so there are not more visits than nodes.
    for _ in 0..nodes.len() {
        let Some((node, cell)) = to_do.pop() else {
            break;
        };
        let Some(row) = nodes.get(node) else { continue };
        let first = row.first as usize;
        if row.inner == 0 {
            found.push((node, cell));
        } else if first > node {
            to_do.extend(
                (0..8)
                    .rev()
                    .map(|child| (first + child, child_cell(&cell, child))),
            );
        }
    }
    found
}
