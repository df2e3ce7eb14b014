//! The questions of `wide_closest`.

use raybook::accel::bvh::build::{Method, cost::Cost};
use raybook::accel::wide_bvh::build::{COST, build as build_wide};
use raybook::accel::wide_bvh::node::Link;
use crate::{sample};
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray};
use raybook::shape::{Shape, mesh::Facet};
use raybook_workbook::exercises::ch07_mesh::Corners;
use raybook_workbook::exercises::ch24_wide_bvh::{WideChild, WideClosest, WideLeaf, WideNode};
use glam::Vec3;
use rand::RngExt;

/// An ordinary question.
pub(super) fn random(rng: &mut Pcg) -> WideClosest {
    let triangles = (0..rng.random_range(28..44)).map(|_| {
        let at = sample::point(rng, 2.5);
        std::array::from_fn(|_| at + sample::point(rng, 1.6))
    });
    let triangles = triangles.collect();
    let max = sample::end(rng, 0.3, 1.0, 5.0);
    let min = if rng.random_bool(0.3) {
        sample::number(rng, 0.5, 3.0)
    } else {
        0.0
    };
    let origin = 4.0 * *sample::direction(rng);
    let direction = Dir3::new_or(sample::point(rng, 1.5) - origin, Dir3::X);
    question(
        triangles,
        Ray::new(origin, direction),
        Interval::new(min, max.max(min + 1.0)),
    )
}

/// Four triangles to a leaf: so a few dozen make a tree in which the order of the search matters.
const SMALL_LEAVES: Cost = Cost {
    block_size: 4,
    most: 4,
    ..COST
};

/// A question about triangles in the tree that the reference builds, its root a node even if a leaf would do.
pub(super) fn question(
    triangles: Vec<[Vec3; 3]>,
    ray: Ray,
    within: Interval,
) -> WideClosest {
    let facets = triangles.iter().zip(0..);
    let facets: Vec<_> = facets.map(|(&corners, id)| Facet { corners, id }).collect();
    let all = facets
        .iter()
        .fold(Aabb::EMPTY, |all, facet| all.union(&facet.bounds()));
    let tree = build_wide(facets, Method::Binned, &SMALL_LEAVES);
    let child = |(bounds, link): (Aabb, Link)| WideChild {
        min: bounds.min,
        max: bounds.max,
        leaf: u32::from(link.as_leaf().is_some()),
        index: link.index() as u32,
    };
    let node = |children: Vec<(Aabb, Link)>| WideNode {
        children: children.into_iter().map(child).collect(),
    };
    let mut nodes: Vec<_> = tree
        .nodes
        .iter()
        .map(|old| node(old.children().collect()))
        .collect();
    if let Some(root) = tree.root.filter(|root| root.as_leaf().is_some()) {
        nodes.push(node(vec![(all, root)]));
    }
    let leaves = tree.leaves.iter().map(|leaf| WideLeaf {
        triangles: leaf.facets().collect(),
    });
    WideClosest {
        ray,
        within,
        nodes,
        leaves: leaves.collect(),
        triangles: triangles
            .into_iter()
            .map(|[p0, p1, p2]| Corners { p0, p1, p2 })
            .collect(),
    }
}
