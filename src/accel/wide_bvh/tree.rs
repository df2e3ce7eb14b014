//! The tree alone: nodes, leaves, and the facets that the leaves hold.

use super::node::{CHILDREN, Leaf, Link, Node, TRIANGLES};
use super::portable::Portable;
use super::search::Closest;
use crate::accel::Count;
use crate::accel::pages;
use crate::math::{aabb::Aabb, interval::Interval, ray::Ray};
use crate::shape::{Hit, mesh::Facet};
use glam::{Vec3, Vec3A};

/// A tree of eight children per node and up to eight triangles per leaf.
#[derive(Debug)]
pub struct Tree {
    /// The nodes, depth-first.
    pub(super) nodes: Vec<Node>,
    /// The leaves, in the order in which the nodes name them.
    pub(super) leaves: Vec<Leaf>,
    /// Where to begin; none if there are no facets.
    pub(super) root: Option<Link>,
    /// The largest |coordinate| along each axis.
    pub(super) largest: Vec3A,
    /// The facets, in the order in which they came.
    pub(super) facets: Vec<Facet>,
}

/// The largest |coordinate| of a box along each axis.
pub(super) fn largest(bounds: &Aabb) -> Vec3A {
    bounds.min.abs().max(bounds.max.abs()).into()
}

impl Clone for Tree {
    /// The lists are in large pages again.
    fn clone(&self) -> Self {
        Self {
            nodes: pages::packed(self.nodes.iter().cloned()),
            leaves: pages::packed(self.leaves.iter().cloned()),
            root: self.root,
            largest: self.largest,
            facets: self.facets.clone(),
        }
    }
}

impl Tree {
    /// The tree of these parts: the facets, the leaves by the places of their facets, and the nodes by their children and
    /// the boxes of these. The root is node 0.
    ///
    /// # Errors
    /// If a leaf or a node has too many members, or names one that does not exist; or a node is a child of itself or of a node
    /// that comes after it.
    pub fn new(
        facets: Vec<Facet>,
        leaves: &[Vec<u32>],
        nodes: &[Vec<(Aabb, Link)>],
    ) -> Result<Self, String> {
        for (i, leaf) in leaves.iter().enumerate() {
            let exist = leaf.iter().all(|&facet| (facet as usize) < facets.len());
            if leaf.len() > TRIANGLES || !exist {
                return Err(format!("leaf {i} cannot hold the facets {leaf:?}"));
            }
        }
        for (i, children) in nodes.iter().enumerate() {
            let exists = |link: Link| match link.as_leaf() {
                Some(leaf) => leaf < leaves.len(),
                None => i < link.index() && link.index() < nodes.len(),
            };
            if children.len() > CHILDREN || !children.iter().all(|&(_, link)| exists(link)) {
                return Err(format!("node {i} cannot have the children {children:?}"));
            }
        }
        let corners = facets.iter().flat_map(|facet| facet.corners);
        let largest = corners.fold(Vec3::ZERO, |largest, p| p.abs().max(largest));
        Ok(Self {
            nodes: nodes.iter().map(|c| Node::new(c.iter().copied())).collect(),
            leaves: leaves.iter().map(|leaf| Leaf::new(&facets, leaf)).collect(),
            root: (!nodes.is_empty()).then_some(Link::node(0)),
            largest: largest.into(),
            facets,
        })
    }

    /// The nodes, depth-first.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// The leaves, in the order in which the nodes name them.
    pub fn leaves(&self) -> &[Leaf] {
        &self.leaves
    }

    /// Where to begin; none if there are no facets.
    pub fn root(&self) -> Option<Link> {
        self.root
    }

    /// The facets, in the order in which they came.
    pub fn facets(&self) -> &[Facet] {
        &self.facets
    }

    /// The nearest hit, searched without special instructions; counts the work.
    pub fn closest(&self, ray: &Ray, within: Interval, count: &mut impl Count) -> Option<Hit> {
        let search = Closest {
            tree: self,
            ray,
            within,
            count,
        };
        Portable.run(search).hit()
    }

    /// Memory in use, in bytes.
    pub(super) fn bytes(&self) -> usize {
        self.searched_bytes() + size_of_val(&*self.facets)
    }

    /// The memory that searches read, in bytes.
    pub(super) fn searched_bytes(&self) -> usize {
        size_of_val(&*self.nodes) + size_of_val(&*self.leaves)
    }
}
