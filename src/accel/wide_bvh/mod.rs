//! wide
#![allow(missing_docs)]

#[cfg(target_arch = "x86_64")]
pub mod avx2;
pub mod lanes;
pub mod node;
pub mod pages;
pub mod portable;
pub mod quick;
pub mod ray;
pub mod stack;
pub mod walk;

use crate::accel::{Accel, Count, list::List};
use crate::accel::bounded::bounded;
use crate::math::{interval::Interval, ray::Ray};
use crate::shape::{Hit, mesh::Facet};
#[cfg(target_arch = "x86_64")]
use avx2::Avx2;
use glam::Vec3A;
use node::{Leaf, Link, Node};
use portable::Portable;

#[derive(Clone, Debug)]
pub struct Tree {
    pub nodes: Vec<Node>,
    pub leaves: Vec<Leaf>,
    pub root: Option<Link>,
    pub largest: Vec3A,
    pub facets: Vec<Facet>,
}

#[derive(Clone, Debug)]
pub struct WideBvh {
    tree: Tree,
    rest: Option<Box<List<Facet>>>,
    #[cfg(target_arch = "x86_64")]
    avx2: Option<Avx2>,
}

impl WideBvh {
    pub fn new(facets: Vec<Facet>) -> Self {
        let all = facets.len();
        let (facets, rest) = bounded(facets);
        let bounded_count = facets.len();
        Self {
            tree: quick::build(facets),
            rest: (bounded_count < all).then(|| Box::new(rest)),
            #[cfg(target_arch = "x86_64")]
            avx2: Avx2::detect(),
        }
    }

    /// Memory in use, in bytes.
    pub fn bytes(&self) -> usize {
        let Tree { nodes, leaves, facets, .. } = &self.tree;
        size_of_val(&nodes[..]) + size_of_val(&leaves[..]) + size_of_val(&facets[..])
    }
}

impl Accel<Facet> for WideBvh {
    fn closest_counted(&self, ray: &Ray, within: Interval, count: &mut impl Count) -> Option<(&Facet, Hit)> {
        let mut beside = None;
        let mut within = within;
        if let Some(rest) = &self.rest {
            beside = rest.closest_counted(ray, within, count);
            within = beside.map_or(within, |(_, hit)| within.before(hit.t));
        }
        let nearest = 'found: {
            #[cfg(target_arch = "x86_64")]
            if let Some(avx2) = self.avx2 {
                break 'found avx2.closest(&self.tree, ray, within, count);
            }
            Portable.closest(&self.tree, ray, within, count)
        };
        match nearest {
            Some(n) => Some((&self.tree.facets[n.facet as usize], n.hit())),
            None => beside,
        }
    }

    fn any(&self, ray: &Ray, within: Interval) -> bool {
        let in_tree = 'found: {
            #[cfg(target_arch = "x86_64")]
            if let Some(avx2) = self.avx2 {
                break 'found avx2.any(&self.tree, ray, within);
            }
            Portable.any(&self.tree, ray, within)
        };
        in_tree || self.rest.as_ref().is_some_and(|rest| rest.any(ray, within))
    }
}
