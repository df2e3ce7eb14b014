//! Searches that leave the loop over the children of a branch too early.

use crate::search::{Found, Node, Tree};
use raybook::math::interval::Interval;
use raybook::math::slab;
use raybook::shape::{Shape, mesh::Facet};
use raybook_workbook::exercises::ch07_mesh::{Corners, MeshHitAnswer};

/// After which child no more are asked.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Until {
    /// After one whose box is met.
    Met,
    /// After one whose box is missed.
    Missed,
}

/// Searches below a node, the nearest child first, of those that are asked.
pub(super) fn walk(tree: &Tree, root: &Node, until: Until) -> Found {
    let mut found = Found::default();
    open(tree, root, until, &mut found);
    found
}

fn open(tree: &Tree, node: &Node, until: Until, found: &mut Found) {
    match node {
        Node::Leaf(ids) => ids.iter().for_each(|&id| test(tree, id, found)),
        &Node::Branch(branch) => {
            found.branches += 1;
            let mut met = Vec::new();
            for (bounds, child) in (tree.children)(branch) {
                found.boxes += 1;
                let inside = slab::clip(&bounds, tree.ray, left(tree, found));
                let is_met = inside.is_some();
                met.extend(inside.map(|inside| (inside.min, child)));
                if is_met == (until == Until::Met) {
                    break;
                }
            }
            met.sort_by(|a, b| a.0.total_cmp(&b.0));
            for (t, child) in met {
                if t <= left(tree, found).max {
                    open(tree, &child, until, found);
                }
            }
        }
    }
}

fn test(tree: &Tree, id: u32, found: &mut Found) {
    found.tests += 1;
    let Corners { p0, p1, p2 } = tree.triangles[id as usize];
    let corners = [p0, p1, p2];
    if let Some(hit) = (Facet { corners, id }).hit(tree.ray, left(tree, found)) {
        found.hit = Some(MeshHitAnswer { t: hit.t, id });
    }
}

/// The distances that still count.
fn left(tree: &Tree, found: &Found) -> Interval {
    let nearest = found.hit.as_ref().map_or(tree.within.max, |hit| hit.t);
    tree.within.before(nearest)
}
