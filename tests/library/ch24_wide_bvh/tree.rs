//! The tree itself: collapse, invariants, threads, and how its work grows.

use crate::ch24_wide_bvh::scenes::facets;
use glam::{Vec3, vec3};
use proptest::prelude::*;
use rand::RngExt;
use raybook::accel::bvh::{Bvh, build::Method};
use raybook::accel::wide_bvh::WideBvh;
use raybook::accel::{Accel, Tests};
use raybook::inside::bvh::{COST, build};
use raybook::inside::wide_bvh::{self, Family, binary, collapse, collapse_optimally, half_area};
use raybook::math::{dir3::Dir3, interval::Interval, pcg, ray::Ray};
use raybook::scene::soup::soup;
use raybook::shape::{Shape, teapot};

proptest! {
    #[test]
    fn every_tree_keeps_to_the_invariants(
        n in 0_u32..400,
        seed in 0_u64..1000,
        method in prop_oneof![
            Just(Method::Fine), Just(Method::Binned), Just(Method::Sweep), Just(Method::Median),
            Just(Method::Middle), Just(Method::BottomUp),
        ],
    ) {
        let tree = WideBvh::build(soup(n, seed).facets(), method);
        prop_assert_eq!(tree.validate(), Ok(()));
        prop_assert_eq!(wide_bvh::tree(&tree).facets().len(), n as usize);
    }
}

#[test]
fn few_and_equal_facets_have_trees_too() {
    let one = [Vec3::ZERO, Vec3::X, Vec3::Z];
    for n in [0, 1, 2, 4, 5, 8, 9, 33, 1000] {
        let tree = WideBvh::new(facets(vec![one; n]));
        assert_eq!(tree.validate(), Ok(()), "{n} facets at the same place");
        let ray = Ray::new(vec3(0.2, 1.0, 0.2), -Dir3::Y);
        let hit = tree.closest(&ray, Interval::AHEAD).map(|(_, hit)| hit.id);
        assert_eq!(
            hit,
            (n > 0).then_some(0),
            "of {n} equal ones the first counts"
        );
    }
}

#[test]
fn nodes_are_nearly_full() {
    let mesh = teapot::mesh(12);
    let tree = WideBvh::new(mesh.facets());
    let nodes = wide_bvh::tree(&tree).nodes();
    let children: usize = nodes.iter().map(|node| node.children().count()).sum();
    let mean = children as f32 / nodes.len() as f32;
    assert!(
        mean > 5.0,
        "{mean} children per node of the teapot; 6.0 were measured"
    );
    let per_leaf = mesh.triangles().len() as f32 / wide_bvh::tree(&tree).leaves().len() as f32;
    assert!(
        per_leaf > 6.5,
        "{per_leaf} triangles per leaf of the teapot; 7.5 were measured"
    );
}

#[test]
fn the_optimal_collapse_has_the_same_leaves_and_fewer_and_smaller_nodes() {
    for mesh in [teapot::mesh(6), soup(3000, 5)] {
        let boxes: Vec<_> = mesh.facets().iter().map(Shape::bounds).collect();
        let nodes = binary(&build(&boxes, Method::Binned, &COST));
        let leaves = |families: &[Family]| {
            let all = families.iter().flat_map(|family| &family.children);
            let mut leaves: Vec<_> = all.filter(|&&i| nodes[i as usize].link.count > 0).collect();
            leaves.sort_unstable();
            leaves.into_iter().copied().collect::<Vec<_>>()
        };
        let area = |families: &[Family]| {
            let areas = families
                .iter()
                .map(|family| half_area(&nodes[family.branch as usize]));
            areas.sum::<f32>()
        };
        let (greedy, optimal) = (collapse(&nodes), collapse_optimally(&nodes));
        assert_eq!(
            leaves(&greedy),
            leaves(&optimal),
            "every leaf is a child once"
        );
        assert!(
            optimal.iter().all(|family| family.children.len() <= 8),
            "no node has more than eight children"
        );
        assert!(
            area(&optimal) < 0.99 * area(&greedy),
            "{} of area, and {} by opening the largest",
            area(&optimal),
            area(&greedy)
        );
        assert!(
            optimal.len() < greedy.len(),
            "{} nodes, and {} by opening the largest",
            optimal.len(),
            greedy.len()
        );
    }
}

#[test]
fn the_same_tree_comes_of_any_number_of_threads() {
    let facets = soup(20_000, 3).facets();
    let trees = || [WideBvh::new, wide_bvh::cut].map(|build| build(facets.clone()));
    let build = || trees().map(|tree| format!("{:?}", wide_bvh::tree(&tree)));
    let pool = |n| {
        rayon::ThreadPoolBuilder::new()
            .num_threads(n)
            .build()
            .expect("threads")
    };
    let trees: Vec<_> = [1, 2, 5].map(|n| pool(n).install(build)).into();
    assert!(
        trees.windows(2).all(|two| two[0] == two[1]),
        "a build must not depend on threads"
    );
}

#[test]
fn steps_are_far_fewer_than_those_of_a_binary_tree() {
    let mesh = soup(30_000, 1);
    let (wide, binary) = (WideBvh::new(mesh.facets()), Bvh::new(mesh.facets()));
    let (mut eight, mut two) = (Tests::default(), Tests::default());
    for ray in rays(500) {
        wide.closest_counted(&ray, Interval::AHEAD, &mut eight);
        binary.closest_counted(&ray, Interval::AHEAD, &mut two);
    }
    assert!(
        2 * eight.boxes < two.boxes / 2,
        "{} nodes of eight, and {} pairs: two and a half times as many were measured",
        eight.boxes,
        two.boxes / 2
    );
}

#[test]
fn work_grows_with_the_logarithm() {
    let work = |n: u32| {
        let tree = WideBvh::new(soup(n, 2).facets());
        let mut tests = Tests::default();
        for ray in rays(400) {
            tree.closest_counted(&ray, Interval::AHEAD, &mut tests);
        }
        tests.boxes as f32 / 400.0
    };
    let counts = [100, 1000, 10_000, 100_000].map(work);
    for (few, many) in counts.iter().zip(&counts[1..]) {
        assert!(
            many - few < 9.0,
            "ten times the triangles, a few nodes more: {counts:?}"
        );
    }
    assert!(
        counts[3] > counts[0],
        "the test must see it grow: {counts:?}"
    );
}

/// Rays through the unit cube.
fn rays(n: usize) -> impl Iterator<Item = Ray> {
    let mut rng = pcg::stream(9, 0);
    let mut at = move || Vec3::from(std::array::from_fn(|_| rng.random::<f32>()));
    (0..n).map(move |_| {
        let (a, b) = (at() * 3.0 - 1.0, at());
        Ray::new(a, Dir3::new_or(b - a, Dir3::X))
    })
}
