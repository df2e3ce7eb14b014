//! The questions of `wide_closest`.

use raybook::accel::bvh::build::Method;
use raybook::inside::bvh::Cost;
use raybook::inside::wide_bvh::{COST, Link, build as build_wide};
use crate::{Edge, sample};
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray};
use raybook::shape::{Shape, mesh::Facet};
use raybook_workbook::exercises::ch07_mesh::Corners;
use raybook_workbook::exercises::ch24_wide_bvh::{
    WideChild, WideClosest, WideClosestQuestion, WideLeaf, WideNode,
};
use glam::{Vec3, vec3};
use rand::RngExt;

/// The cases that are most often got wrong.
pub(super) fn edges() -> Vec<Edge<WideClosest>> {
    let wall = |z: f32| [vec3(-2.0, -2.0, z), vec3(2.0, -2.0, z), vec3(0.0, 3.0, z)];
    let walls = |n: usize, ray, within| {
        question((1..=n).map(|i| wall(2.0 * i as f32)).collect(), ray, within)
    };
    let (ray, ahead) = (sample::ray(Vec3::ZERO, Vec3::Z), Interval::AHEAD);
    let back = sample::ray(vec3(0.0, 0.0, 100.0), -Vec3::Z);
    let minus_zero = sample::ray(Vec3::ZERO, vec3(-0.0, -0.0, 1.0));
    let slanted = (1..=24).map(|i| {
        let z = 2.0 * i as f32;
        [
            vec3(-2.0, -2.0, z - 3.0),
            vec3(2.0, -2.0, z - 3.0),
            vec3(0.0, 3.0, z + 4.0),
        ]
    });
    let tilted = |i: usize| {
        let z = i as f32;
        [
            vec3(-2.0, -2.0, 2.0 + 0.1 * z),
            vec3(2.0, -2.0, 2.0),
            vec3(0.0, 3.0, 40.0),
        ]
    };
    let late = (0..4)
        .map(tilted)
        .chain((0..16).map(|i| wall(8.0 + i as f32)))
        .collect();
    vec![
        Edge::new("forty walls ahead", walls(40, ray, ahead)),
        Edge::new("forty walls, from the other end", walls(40, back, ahead)),
        Edge::new(
            "from between the walls",
            walls(40, sample::ray(vec3(0.0, 0.0, 31.0), Vec3::Z), ahead),
        ),
        Edge::new(
            "the nearest walls lie before the interval",
            walls(40, ray, Interval::new(21.0, 90.0)),
        ),
        Edge::new(
            "all walls beyond the interval",
            walls(40, ray, Interval::new(0.0, 1.5)),
        ),
        Edge::new(
            "a miss",
            walls(40, sample::ray(vec3(5.0, 0.0, 0.0), Vec3::Z), ahead),
        ),
        Edge::new("−0.0 in the direction", walls(40, minus_zero, ahead)),
        Edge::new(
            "a slanted wall begins first and ends last",
            question(late, ray, ahead),
        ),
        Edge::new(
            "boxes that overlap",
            question(slanted.collect(), ray, ahead),
        ),
        Edge::new("one leaf", walls(3, ray, ahead)),
    ]
}

/// An ordinary question.
pub(super) fn random(rng: &mut Pcg) -> WideClosestQuestion {
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
) -> WideClosestQuestion {
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
        .nodes()
        .iter()
        .map(|old| node(old.children().collect()))
        .collect();
    if let Some(root) = tree.root().filter(|root| root.as_leaf().is_some()) {
        nodes.push(node(vec![(all, root)]));
    }
    let leaves = tree.leaves().iter().map(|leaf| WideLeaf {
        triangles: leaf.facets().collect(),
    });
    WideClosestQuestion {
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
