//! Chapter 10: the octree.

mod laws;
mod repeats;
use raybook_common::rays;
mod walk;
use raybook_common::whole;

use glam::{Vec3, vec3};
use rand::RngExt;
use raybook::accel::Accel;
use raybook::accel::octree::{Octree, build::Limits, reach::by_triangle};
use raybook::inside::octree::{self, child_at, child_cell};
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, pcg, ray::Ray};
use raybook::scene::soup::soup;
use raybook::shape::{mesh::Facet, teapot};

fn valid(octree: Octree<Facet>) -> Octree<Facet> {
    assert_eq!(octree.validate(), Ok(()), "an octree keeps its promises");
    octree
}

fn triangle(id: u32, corners: [Vec3; 3]) -> Facet {
    Facet { corners, id }
}

#[test]
fn the_children_of_a_cell_fill_it_and_hold_their_points() {
    let cell = Aabb {
        min: vec3(-1.0, 2.0, 10.0),
        max: vec3(3.0, 6.0, 14.0),
    };
    let mut rng = pcg::stream(1, 1);
    for _ in 0..1000 {
        let p = cell.min + cell.size() * Vec3::from_array(std::array::from_fn(|_| rng.random()));
        let children = (0..8).filter(|&i| child_cell(&cell, i).contains(p));
        assert!(
            children.clone().count() >= 1,
            "{p} is in a child, for there are no gaps"
        );
        let at = child_at(&cell, p);
        assert!(children.clone().any(|i| i == at), "{p} is in child {at}");
    }
    assert_eq!(
        child_at(&cell, cell.center()),
        7,
        "middle planes belong to the upper halves"
    );
}

#[test]
fn every_point_of_a_triangle_lies_in_a_leaf_that_names_it() {
    let octree = valid(Octree::of_facets(teapot::mesh(4).facets()));
    let mut rng = pcg::stream(2, 2);
    for (i, facet) in (0..).zip(octree::shapes(&octree)) {
        for _ in 0..8 {
            let (b, c) = (rng.random::<f32>(), rng.random::<f32>());
            let (b, c) = if b + c > 1.0 {
                (1.0 - b, 1.0 - c)
            } else {
                (b, c)
            };
            let [p0, p1, p2] = facet.corners;
            let p = p0 + b * (p1 - p0) + c * (p2 - p0);
            let leaf = octree::tree(&octree).leaf_at(p);
            // By rounding, a point on a face of its leaf may be on the wrong side of it.
            let inside = (p - leaf.cell.min).min(leaf.cell.max - p).min_element() > 1e-6;
            let named = octree::tree(&octree).shapes_in(leaf.node).contains(&i);
            assert!(named || !inside, "{p} of triangle {i} is in leaf {leaf:?}");
        }
    }
}

#[test]
fn cutting_ends_where_it_does_not_help() {
    let fan = (0..64).map(|i| {
        let angle = i as f32 * 0.1;
        let arm = |a: f32| vec3(a.cos(), a.sin(), (3.0 * a).sin());
        triangle(i, [Vec3::ZERO, arm(angle), arm(angle + 0.1)])
    });
    let thousand = vec![triangle(0, [Vec3::X, Vec3::Y, Vec3::Z]); 1000];
    let huge = (0..200).map(|i| {
        let z = i as f32 * 0.01;
        triangle(
            i,
            [vec3(-9.0, -9.0, z), vec3(9.0, -9.0, z), vec3(0.0, 9.0, z)],
        )
    });
    for (name, facets) in [
        ("triangles that share a corner", fan.collect::<Vec<_>>()),
        ("a thousand equal triangles", thousand),
        ("large sheets close together", huge.collect()),
        ("a soup", soup(3000, 3).facets()),
    ] {
        let count = facets.len();
        let octree = valid(Octree::of_facets(facets));
        let tree = octree::tree(&octree);
        let copies = tree.named.len() as f32 / count as f32;
        assert!(
            copies <= Limits::USUAL.copies,
            "{name}: {copies} copies of each"
        );
        let nodes = tree.nodes.len() as f32 / count as f32;
        assert!(nodes < 16.0, "{name}: {nodes} nodes per triangle");
    }
    let none = valid(Octree::of_facets(Vec::new()));
    let ahead = none.closest(&Ray::new(Vec3::ZERO, Dir3::X), Interval::AHEAD);
    assert_eq!(ahead, None, "an empty octree has no hits");
}

#[test]
fn no_leaf_is_deeper_than_a_walk_can_follow() {
    // Each pair is half as far apart as the one before: there is always something to part.
    let pairs = (0..40).flat_map(|i| {
        let x = 0.5_f32.powi(i);
        [x, 1.1 * x].map(|x| triangle(i as u32, [x, x * 1.001, x * 1.002].map(Vec3::splat)))
    });
    let octree = valid(Octree::new(pairs.collect()));
    let deepest = octree::tree(&octree)
        .places()
        .iter()
        .map(|place| place.depth)
        .max();
    assert_eq!(
        deepest,
        Some(Limits::DEEPEST),
        "the limit is reached and kept"
    );
}

#[test]
fn a_broken_tree_is_told() {
    // An octree that forgets what lies in two halves: validate says that a shape is lost.
    let forgetful = |facet: &Facet, cells: &[Aabb; 8]| {
        let bits = by_triangle(facet, cells);
        if bits.is_power_of_two() { bits } else { 0 }
    };
    let octree = Octree::with(teapot::mesh(3).facets(), Limits::USUAL, forgetful);
    let told = octree.validate().expect_err("triangles are lost");
    assert!(told.contains("is in no leaf"), "{told}");
}
