//! The same tree over facets that have moved.

use super::node::{Leaf, Link, NO_FACET, Node, TRIANGLES};
use super::tree::{Tree, largest};
use crate::math::aabb::Aabb;
use crate::shape::{Shape, mesh::Facet};
use crate::threads;

/// Gives a tree the facets as they are now, as many as before and in the same order, and makes all boxes fit again.
///
/// Each leaf keeps its facets. Children come after their node in the list, so the nodes are done from the last to the first:
/// then the boxes of a node's children are known.
pub(super) fn refit(tree: &mut Tree, facets: Vec<Facet>) {
    let members = threads::list(tree.leaves.len(), |i| tree.leaves[i].facets);
    let leaf = |i: usize| {
        let end = members[i].iter().position(|&facet| facet == NO_FACET);
        Leaf::new(&facets, &members[i][..end.unwrap_or(TRIANGLES)])
    };
    threads::fill(&mut tree.leaves, members.len(), leaf);
    let around = |leaf: &Leaf| {
        let boxes = leaf.facets().map(|facet| facets[facet as usize].bounds());
        boxes.fold(Aabb::EMPTY, |all, bounds| all.union(&bounds))
    };
    let leaves = threads::list(members.len(), |i| around(&tree.leaves[i]));
    let mut nodes = vec![Aabb::EMPTY; tree.nodes.len()];
    for (i, node) in tree.nodes.iter_mut().enumerate().rev() {
        let links = node.children().map(|(_, link)| link);
        let now = Node::new(links.map(|link| (below(link, &nodes, &leaves), link)));
        nodes[i] = now
            .children()
            .fold(Aabb::EMPTY, |all, (bounds, _)| all.union(&bounds));
        *node = now;
    }
    if let Some(root) = tree.root {
        tree.largest = largest(&below(root, &nodes, &leaves));
    }
    tree.facets = facets;
}

/// The box of a child.
fn below(link: Link, nodes: &[Aabb], leaves: &[Aabb]) -> Aabb {
    match link.as_leaf() {
        Some(leaf) => leaves[leaf],
        None => nodes[link.index()],
    }
}
