//! A ray's way through the leaves.

use crate::ch10_octree::rays::{random_direction, ray};
use crate::ch10_octree::valid;
use glam::{Vec3, vec3};
use raybook::accel::octree::Octree;
use raybook::accel::{Accel, Tests, list::List};
use raybook::inside::octree::{self, Walk};
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, pcg, ray::Ray};
use raybook::scene::soup::soup;
use raybook::shape::{sphere::Sphere, teapot};

#[test]
fn leaves_come_in_order_and_none_that_matters_is_left_out() {
    let octree = valid(Octree::of_facets(soup(400, 5).facets()));
    let tree = octree::tree(&octree);
    let places = tree.places();
    let leaves: Vec<_> = places
        .iter()
        .filter(|place| !tree.range(place.node).is_empty())
        .collect();
    let mut rng = pcg::stream(4, 4);
    let mut visited = 0;
    for i in 0..2000 {
        let middle = tree.bounds.center();
        let mut from = middle + 0.9 * *random_direction(&mut rng);
        let mut toward = middle + 0.3 * *random_direction(&mut rng) - from;
        if i % 4 == 0 {
            // Along an axis, with a zero of either sign, in a plane of the tree.
            let axis = i / 4 % 3;
            let keep = toward[axis];
            toward = if i % 8 == 0 { Vec3::ZERO } else { -Vec3::ZERO };
            toward[axis] = keep;
            from[(axis + 1) % 3] = middle[(axis + 1) % 3];
        }
        let ray = ray(from, toward);
        let mut walk = Walk::new(tree, &ray, Interval::AHEAD);
        let got: Vec<_> = std::iter::from_fn(|| walk.next_leaf(f32::INFINITY, &mut ())).collect();
        visited += got.len();
        let stay = |cell: &Aabb| {
            let inside = raybook::math::slab::clip(cell, &ray, Interval::AHEAD)?;
            (inside.max - inside.min > 1e-4).then_some(inside)
        };
        let mut left = 0.0;
        for leaf in &got {
            let place = places
                .iter()
                .find(|place| place.node == *leaf)
                .expect("a node");
            // A ray in a plane is in the leaves on both sides at once: then one side comes after the other.
            if i % 4 != 0
                && let Some(inside) = stay(&place.cell)
            {
                assert!(
                    inside.max > left - 1e-4,
                    "leaf {leaf} comes too late on {ray:?}"
                );
                left = inside.min;
            }
        }
        for leaf in &leaves {
            if stay(&leaf.cell).is_some() {
                assert!(
                    got.contains(&leaf.node),
                    "leaf {leaf:?} is left out by {ray:?}"
                );
            }
        }
    }
    assert!(visited > 5000, "the rays visit leaves: {visited}");
}

#[test]
fn a_hit_ends_the_walk() {
    let octree = valid(Octree::of_facets(teapot::mesh(8).facets()));
    let list = teapot::mesh(8).facets().len() as u64;
    let toward = octree::tree(&octree).bounds.center();
    let mut tests = Tests::default();
    let mut rng = pcg::stream(6, 6);
    for _ in 0..200 {
        let from = toward + 9.0 * *random_direction(&mut rng);
        octree.closest_counted(&ray(from, toward - from), Interval::AHEAD, &mut tests);
    }
    let Tests { boxes, shapes } = tests;
    assert!(
        100 * shapes < 200 * list && boxes < 200 * 40,
        "{shapes} triangles of {list} and {boxes} nodes for 200 rays"
    );
    assert!(boxes > 200 && shapes > 0, "it counts");
}

#[test]
fn shapes_of_any_kind_and_without_bounds_are_found() {
    let balls = vec![
        Sphere::new(Vec3::ZERO, 1.0),
        Sphere {
            center: vec3(f32::NAN, 0.0, 0.0),
            radius: 1.0,
        },
    ];
    let octree = Octree::new(balls.clone());
    assert_eq!(octree.validate(), Ok(()));
    let down = Ray::new(vec3(0.2, 5.0, 0.1), -Dir3::Y);
    let (list, found) = (List::new(balls), octree.closest(&down, Interval::AHEAD));
    let expected = list.closest(&down, Interval::AHEAD).map(|(_, hit)| hit);
    assert_eq!(
        found.map(|(_, hit)| hit),
        expected,
        "a ball is found, with a NaN beside it"
    );
    assert!(octree.any(&down, Interval::AHEAD), "and it blocks");
}
