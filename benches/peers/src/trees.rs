//! The nodes of raybook's own trees, each with the root among them.

use crate::sah::{Inside, Node};
use raybook::accel::{bvh::Bvh, wide_bvh::WideBvh};
use raybook::inside::{bvh, wide_bvh};
use raybook::math::aabb::Aabb;
use raybook::shape::mesh::Facet;

/// Those of a tree of two children.
pub fn binary(of: &Bvh<Facet>) -> Vec<Node> {
    let (root, pairs) = bvh::nodes(of);
    let below = pairs.iter().flat_map(bvh::Pair::nodes);
    let inside = |count| match count {
        0 => Inside::Children(2),
        count => Inside::Triangles(count as usize),
    };
    let node = |node: bvh::Node| (node.bounds, inside(node.link.count));
    root.copied().into_iter().chain(below).map(node).collect()
}

/// Those of a tree of eight children. It does not store the root's box.
pub fn wide(of: &WideBvh, root: Aabb) -> Vec<Node> {
    let tree = wide_bvh::tree(of);
    let inside = |link: wide_bvh::Link| match link.as_leaf() {
        Some(leaf) => Inside::Triangles(tree.leaves()[leaf].facets().count()),
        None => Inside::Children(tree.nodes()[link.index()].children().count()),
    };
    let root = tree.root().map(|link| (root, link));
    let below = tree.nodes().iter().flat_map(wide_bvh::Node::children);
    let node = |(bounds, link)| (bounds, inside(link));
    root.into_iter().chain(below).map(node).collect()
}
