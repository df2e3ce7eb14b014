//! Chapter 10: the octree.

#[path = "common/rays.rs"]
mod rays;

use glam::{Vec3, vec3};
use proptest::prelude::*;
use rand::RngExt;
use raybook::accel::octree::tree::{Kind, child_at, child_cell};
use raybook::accel::octree::{Octree, build::Limits, reach::by_triangle, walk::Walk};
use raybook::accel::{Accel, Tests, list::List};
use raybook::lab::law::{Reach, fit, mean_tests};
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, pcg, ray::Ray};
use raybook::scene::soup::soup;
use raybook::shape::{mesh::Facet, sphere::Sphere, teapot};
use rays::{random_direction, ray};

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
    for (i, facet) in (0..).zip(octree.shapes()) {
        for _ in 0..8 {
            let (b, c) = (rng.random::<f32>(), rng.random::<f32>());
            let (b, c) = if b + c > 1.0 {
                (1.0 - b, 1.0 - c)
            } else {
                (b, c)
            };
            let [p0, p1, p2] = facet.corners;
            let p = p0 + b * (p1 - p0) + c * (p2 - p0);
            let leaf = octree.tree().leaf_at(p);
            // By rounding, a point on a face of its leaf may be on the wrong side of it.
            let inside = (p - leaf.cell.min).min(leaf.cell.max - p).min_element() > 1e-6;
            let named = octree.tree().shapes_in(leaf.node).contains(&i);
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
        let tree = octree.tree();
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
    let deepest = octree.tree().places().iter().map(|place| place.depth).max();
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

#[test]
fn leaves_come_in_order_and_none_that_matters_is_left_out() {
    let octree = valid(Octree::of_facets(soup(400, 5).facets()));
    let tree = octree.tree();
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
    let toward = octree.tree().bounds.center();
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
        Sphere::new(vec3(f32::NAN, 0.0, 0.0), 1.0),
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

/// The law of this chapter, from 10² to 10⁶ triangles. What it costs to find a place in the tree is its depth, and that is
/// log₈ N plus what small leaves add. A ray through the whole soup also passes through leaves on its way, ∛N of them at
/// first; but a large soup is opaque, and the ray ends after as many leaves as before.
#[test]
fn nodes_grow_with_the_logarithm_of_the_number_of_triangles() {
    let near: Vec<_> = [100, 1000, 10_000, 100_000, 1_000_000]
        .map(|n| (f64::from(n), mean_tests(n, Reach::Near, Octree::new)))
        .into();
    let nodes: Vec<_> = near.iter().map(|&(n, tests)| (n, tests[0])).collect();
    let [a, b] = fit(&nodes);
    println!("nodes {nodes:?}: {a:.2} + {b:.2} log10 N");
    // A level has eight times as many cells: 1/log₁₀ 8 = 1.11 levels per power of ten; near a face a ray enters two cells.
    assert!(
        (1.1..1.7).contains(&b),
        "{b:.2} nodes more for ten times as many triangles"
    );
    for (n, count) in nodes {
        let law = a + b * n.log10();
        assert!(
            (count - law).abs() < 0.5,
            "{count:.2} nodes with {n} triangles, by the law {law:.2}"
        );
    }
    let tests = near.iter().map(|&(_, tests)| tests[1]);
    let (least, most) = tests.fold((f64::INFINITY, 0.0_f64), |(a, b), t| (a.min(t), b.max(t)));
    assert!(
        most < 1.5 * least,
        "triangles tested do not grow: {least:.1} to {most:.1}"
    );
}

proptest! {
    #[test]
    fn the_octree_agrees_with_the_list(
        corners in prop::collection::vec(prop::array::uniform3(prop::array::uniform3(-3_i8..4)), 0..40),
        from in prop::array::uniform3(-5_i8..6),
        to in prop::array::uniform3(-3_i8..4),
        scale in -6_i32..7,
    ) {
        // Whole numbers: corners and rays lie in planes of the tree, and rays meet edges.
        let scale = 10.0_f32.powi(scale);
        let point = |p: [i8; 3]| scale * Vec3::from_array(p.map(f32::from));
        let facets: Vec<_> = (0..).zip(&corners).map(|(id, &c)| triangle(id, c.map(point))).collect();
        let (from, to) = (point(from), point(to));
        prop_assume!(from != to);
        let ray = ray(from, to - from);
        let list = List::new(facets.clone());
        let expected = list.closest(&ray, Interval::AHEAD).map(|(_, hit)| hit.t);
        for octree in [Octree::of_facets(facets.clone()), Octree::new(facets)] {
            prop_assert_eq!(octree.validate(), Ok(()));
            let found = octree.closest(&ray, Interval::AHEAD).map(|(_, hit)| hit.t);
            let close = match (expected, found) {
                (Some(a), Some(b)) => (a - b).abs() <= 32.0 * f32::EPSILON * 10.0 * scale,
                (a, b) => a == b,
            };
            prop_assert!(close, "{:?} and not {:?}", found, expected);
            prop_assert_eq!(octree.any(&ray, Interval::AHEAD), found.is_some());
        }
    }

    #[test]
    fn kinds_survive_their_packing(first in 0..u32::MAX, count in 0..1_u32 << 31, occupied in 0..=255_u8) {
        use raybook::accel::octree::tree::Node;
        prop_assert_eq!(Node::leaf(first, count).kind(), Kind::Leaf { first, count });
        prop_assert_eq!(Node::inner(first, occupied).kind(), Kind::Inner { children: first, occupied });
    }
}
