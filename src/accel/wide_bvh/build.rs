//! From facets to the tree.

use super::collapse::{binary, half_area};
use super::node::{Leaf, Link, Node, TRIANGLES};
use super::optimal;
use super::pages;
use super::tree::{Tree, largest};
use crate::accel::bvh::build::{Method, build as build_binary, cost::Cost};
use crate::shape::{Shape, mesh::Facet};
use crate::threads;
use glam::Vec3A;

/// Eight boxes at once cost about half as much as a block of triangles; the binary tree, which has seven branches in place
/// of one node, is made with this in mind.
pub(crate) const COST: Cost = Cost {
    branch: 0.5,
    block: 1.0,
    block_size: TRIANGLES as u32,
    most: TRIANGLES as u32,
};

/// The most that nodes and leaves may take per facet; with the facet itself, 500 bytes.
///
/// Facets that are tiny, and far from each other, get a leaf each. Where nodes then are badly filled too, halves fill leaves
/// better.
const MOST_BYTES: usize = 500 - size_of::<Facet>();

/// The tree of facets with finite boxes; leaves have at most `cost.most` of them, and [`TRIANGLES`].
pub(crate) fn build(facets: Vec<Facet>, method: Method, cost: &Cost) -> Tree {
    let boxes = threads::list(facets.len(), |i| facets[i].bounds());
    let most = cost.most.min(TRIANGLES as u32);
    let flat = build_binary(&boxes, method, &Cost { most, ..*cost });
    let old = binary(&flat);
    let families = optimal::collapse(&old);
    // Where each node of the binary tree that stays is in the new one.
    let mut links = vec![Link::NONE; old.len()];
    for (place, family) in families.iter().enumerate() {
        links[family.branch as usize] = Link::node(place);
    }
    let kept = families.iter().flat_map(|family| &family.children);
    let kept = old.first().map(|_| &0).into_iter().chain(kept);
    let chosen: Vec<u32> = kept
        .copied()
        .filter(|&i| old[i as usize].link.count > 0)
        .collect();
    let bytes = families.len() * size_of::<Node>() + chosen.len() * size_of::<Leaf>();
    if bytes > MOST_BYTES * facets.len() && method != Method::Median {
        return build(facets, Method::Median, cost);
    }
    for (place, &leaf) in chosen.iter().enumerate() {
        links[leaf as usize] = Link::leaf(place);
    }
    let mut nodes = pages::list(families.len());
    let member = |&i: &u32| (old[i as usize].bounds, links[i as usize]);
    let node = |i: usize| {
        // The largest first: any-hit searches open the first child that is met, and most rays are blocked there.
        let area = |&i: &u32| half_area(&old[i as usize]);
        let mut children = families[i].children.clone();
        children.sort_by(|a, b| area(b).total_cmp(&area(a)));
        Node::new(children.iter().map(member))
    };
    threads::fill(&mut nodes, families.len(), node);
    let mut leaves = pages::list(chosen.len());
    let leaf = |i: usize| {
        let node = &old[chosen[i] as usize];
        Leaf::new(
            &facets,
            &flat.order[node.link.first as usize..][..node.link.count as usize],
        )
    };
    threads::fill(&mut leaves, chosen.len(), leaf);
    Tree {
        root: links.first().copied(),
        largest: old
            .first()
            .map_or(Vec3A::ZERO, |root| largest(&root.bounds)),
        nodes,
        leaves,
        facets,
    }
}
