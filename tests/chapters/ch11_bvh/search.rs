//! The search: how much it tests, and what a wrong one would do.

use crate::ch11_bvh::METHODS;
use glam::{Vec3, vec3};
use raybook::accel::{Accel, Tests, bvh::Bvh, list::List};
use raybook::inside::bvh::{self, Node, RayPair};
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::mesh::Facet;
use raybook::shape::{Hit, Shape};
use raybook_chapters::shared::{law::Reach, law::mean_tests};

#[test]
fn tests_grow_with_the_logarithm_of_the_number_of_triangles() {
    let sizes = [100, 1000, 10_000, 100_000, 1_000_000];
    let tests = sizes.map(|n| mean_tests(n, Reach::Inside, Bvh::new).iter().sum::<f64>());
    println!("{tests:?}");
    // ∝ log N: each tenfold adds about as much as the first, at most 1.26 times as much as measured; any power of N would add
    // more and more, N^⅕ four times as much in the end.
    let added: Vec<_> = tests.windows(2).map(|two| two[1] - two[0]).collect();
    assert!(
        added
            .iter()
            .all(|more| *more > 0.0 && *more <= 1.5 * added[0]),
        "ten times as many triangles add {added:?} tests"
    );
    assert!(
        tests[4] < 12.0 * tests[0],
        "a million cost {} times a hundred",
        tests[4] / tests[0]
    );
    let list = mean_tests(1000, Reach::Inside, List::new);
    assert_eq!(list, [0.0, 1000.0], "the list asks all");
}

/// Walls one behind the other, the ray at right angles.
fn walls() -> (Vec<Facet>, Ray) {
    let wall = |id: u32| {
        let z = -f64::from(id) as f32;
        Facet {
            corners: [vec3(-9.0, -9.0, z), vec3(9.0, -9.0, z), vec3(0.0, 9.0, z)],
            id,
        }
    };
    let ray = Ray::new(vec3(0.0, 0.0, 0.5), -Dir3::Z);
    ((0..256).map(wall).collect(), ray)
}

#[test]
fn behind_the_first_wall_nothing_is_opened() {
    let (walls, ray) = walls();
    for method in METHODS {
        let tree = Bvh::build(walls.clone(), method);
        let mut tests = Tests::default();
        let (_, hit) = tree
            .closest_counted(&ray, Interval::AHEAD, &mut tests)
            .expect("a wall");
        assert_eq!((hit.id, hit.t), (0, 0.5), "{method:?}: the nearest wall");
        assert!(
            tests.shapes <= 8 && tests.boxes <= 2 * 64,
            "{method:?}: one leaf and the way there, not {tests:?}"
        );
    }
}

/// A search of the reference's tree that may go wrong in one of two ways.
fn planted(
    tree: &Bvh<Facet>,
    walls: &[Facet],
    ray: &Ray,
    shrinks: bool,
    keeps_last: bool,
) -> (Option<Hit>, u32) {
    let (root, pairs) = bvh::nodes(tree);
    let mut within = Interval::AHEAD;
    let mut open: Vec<Node> = root.copied().into_iter().collect();
    let all = root.map_or(Aabb::EMPTY, |root| root.bounds);
    let (mut found, mut tests) = (None::<Hit>, 0);
    while let Some(node) = open.pop() {
        let link = node.link;
        if link.count == 0 {
            let pair = &pairs[link.first as usize];
            let mut met: Vec<_> = RayPair::new(ray, within, &all)
                .enters(pair)
                .into_iter()
                .zip(pair.nodes())
                .filter_map(|(enters, node)| Some((enters?, node)))
                .collect();
            met.sort_by(|a, b| b.0.total_cmp(&a.0));
            open.extend(met.into_iter().map(|(_, node)| node));
            continue;
        }
        for wall in walls {
            let bounds = wall.bounds();
            if bounds.union(&node.bounds) != node.bounds {
                continue;
            }
            tests += 1;
            if let Some(hit) = wall.hit(ray, within) {
                if keeps_last || found.is_none_or(|best| hit.t < best.t) {
                    found = Some(hit);
                }
                if shrinks {
                    within = within.before(hit.t);
                }
            }
        }
    }
    (found, tests)
}

#[test]
fn planted_mistakes_of_the_search_are_noticed() {
    let (walls, ray) = walls();
    let tree = Bvh::new(walls.clone());
    let first = |found: Option<Hit>| found.expect("a wall").id;
    let (right, few) = planted(&tree, &walls, &ray, true, false);
    assert_eq!(
        first(right),
        0,
        "without a mistake the nearest wall is found"
    );
    let (still_right, many) = planted(&tree, &walls, &ray, false, false);
    assert_eq!(
        first(still_right),
        0,
        "t_max is not shrunk: the hit is still right"
    );
    assert!(
        many >= 256 && 10 * few < many,
        "but the work shows it: {many} tests, not {few}"
    );
    let (last, _) = planted(&tree, &walls, &ray, false, true);
    assert_ne!(first(last), 0, "the last hit instead of the nearest");
}

#[test]
fn a_ray_in_a_face_of_a_box_finds_what_is_in_it() {
    // The box of the triangle is flat, and the ray runs in its plane, up to the edge of the next triangle.
    let flat = Facet {
        corners: [Vec3::ZERO, Vec3::X, Vec3::Y],
        id: 0,
    };
    let across = Facet {
        corners: [
            vec3(0.5, -1.0, -1.0),
            vec3(0.5, 2.0, -1.0),
            vec3(0.5, 0.25, 2.0),
        ],
        id: 1,
    };
    let shift = |facet: &Facet, by: f32| Facet {
        corners: facet.corners.map(|p| p + by * Vec3::Y),
        ..*facet
    };
    let facets: Vec<_> = (0..20)
        .flat_map(|i| [&flat, &across].map(|f| shift(f, 3.0 * i as f32)))
        .collect();
    for direction in [
        vec3(1.0, 0.0, 0.0),
        vec3(1.0, -0.0, -0.0),
        vec3(1.0, -0.0, 0.0),
    ] {
        let ray = Ray::new(vec3(-1.0, 30.0, 0.0), Dir3::new_or(direction, Dir3::X));
        for method in METHODS {
            let tree = Bvh::build(facets.clone(), method);
            let hit = tree.closest(&ray, Interval::AHEAD).map(|(_, hit)| hit.t);
            assert_eq!(hit, Some(1.5), "{method:?} along {direction}");
        }
    }
}
