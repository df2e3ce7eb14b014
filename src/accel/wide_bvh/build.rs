//! From facets to the tree.

use super::collapse::{Family, binary, half_area};
use super::node::{Leaf, Link, Node, TRIANGLES};
use super::optimal;
use super::spatial;
use super::tree::{Tree, largest};
use crate::accel::bvh::build::{
    Method, build as build_binary, cost::Cost, flat::Flat, flat::Node as Old,
};
use crate::accel::pages;
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

/// Maximum size of nodes and leaves per facet, in bytes; with the facet itself, and the plan by which they are made, it is 500.
///
/// Facets that are tiny, and far from each other, get a leaf each. If nodes are badly filled too, splits at the median fill the
/// leaves better.
const MOST_BYTES: usize = 300;

/// The best tree of facets with finite boxes: with cuts where they pay.
pub(super) fn best(facets: Vec<Facet>) -> Tree {
    if spatial::pays(&facets) {
        cut(facets)
    } else {
        build(facets, Method::Fine, &COST)
    }
}

/// The tree of facets with finite boxes, which are cut: they are in at most two leaves on average.
pub(super) fn cut(facets: Vec<Facet>) -> Tree {
    match Plan::new(spatial::build(&facets, &COST, facets.len())).within(facets.len()) {
        Some(plan) => plan.tree(facets),
        None => build(facets, Method::Fine, &COST),
    }
}

/// The tree of facets with finite boxes; leaves have at most `cost.most` of them, and [`TRIANGLES`].
pub(crate) fn build(facets: Vec<Facet>, method: Method, cost: &Cost) -> Tree {
    let most = cost.most.min(TRIANGLES as u32);
    let cost = Cost { most, ..*cost };
    let plan = |method| {
        let boxes = threads::list(facets.len(), |i| facets[i].bounds());
        Plan::new(build_binary(&boxes, method, &cost))
    };
    let plan = plan(method)
        .within(facets.len())
        .unwrap_or_else(|| plan(Method::Median));
    plan.tree(facets)
}

/// What stays of a binary tree.
struct Plan {
    /// The binary tree.
    old: Vec<Old>,
    /// The facets of its leaves.
    order: Vec<u32>,
    /// The nodes that stay.
    families: Vec<Family>,
    /// The leaves that stay, in the order in which the nodes name them.
    chosen: Vec<u32>,
}

impl Plan {
    fn new(flat: Flat) -> Self {
        let old = binary(&flat);
        let families = optimal::collapse(&old);
        let kept = families.iter().flat_map(|family| &family.children);
        let kept = old.first().map(|_| &0).into_iter().chain(kept);
        let is_leaf = |&i: &u32| old[i as usize].link.count > 0;
        Self {
            chosen: kept.copied().filter(is_leaf).collect(),
            families,
            old,
            order: flat.order,
        }
    }

    /// The plan, if nodes and leaves will take no more than [`MOST_BYTES`] for each of the facets.
    fn within(self, facets: usize) -> Option<Self> {
        let bytes = self.families.len() * size_of::<Node>() + self.chosen.len() * size_of::<Leaf>();
        (bytes <= MOST_BYTES * facets).then_some(self)
    }

    /// The tree, over the facets from whose boxes the binary one was made.
    fn tree(self, facets: Vec<Facet>) -> Tree {
        let Self {
            old,
            order,
            families,
            chosen,
        } = self;
        // Where each node of the binary tree that stays is in the new one.
        let mut links = vec![Link::NONE; old.len()];
        for (place, family) in families.iter().enumerate() {
            links[family.branch as usize] = Link::node(place);
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
            let link = old[chosen[i] as usize].link;
            let (first, count) = (link.first as usize, link.count as usize);
            Leaf::new(&facets, &order[first..][..count])
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
}
