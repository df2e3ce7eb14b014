//! Long thin triangles are cut, and nothing is lost by it.

use super::scenes::facets;
use glam::{Vec3, vec3};
use rand::RngExt;
use raybook::accel::{Accel, Tests, bvh::build::Method, list::List, wide_bvh::WideBvh};
use raybook::inside::bvh::{Item, sah_split};
use raybook::inside::wide_bvh::{self, COST, split_of_few};
use raybook::math::{dir3::Dir3, interval::Interval, pcg, ray::Ray};
use raybook::scene::soup::soup;
use raybook::shape::{Shape, mesh::Facet};

/// Facets of one rope.
const ROPE: usize = 8;

/// Ropes across a hall, each of four sides, 2000 times as long as wide, open at their ends; and small triangles, as many of them
/// as wanted, between the ropes.
fn hall(ropes: usize, small: u32) -> Vec<Facet> {
    let mut rng = pcg::stream(20, 0);
    let mut point = || Vec3::from_array(std::array::from_fn(|_| rng.random::<f32>()));
    let rope = |_| {
        let (from, to) = (10.0 * point(), 10.0 * point());
        let (u, v) = (to - from).normalize_or(Vec3::X).any_orthonormal_pair();
        let ring = [u, v, -u, -v].map(|p| 0.002 * p);
        let side = move |i: usize| {
            let (p, q) = (ring[i], ring[(i + 1) % 4]);
            [[from + p, from + q, to + p], [from + q, to + q, to + p]]
        };
        (0..4).flat_map(side)
    };
    let ropes: Vec<_> = (0..ropes).flat_map(rope).collect();
    let small = soup(small, 1).facets().into_iter();
    facets(
        ropes
            .into_iter()
            .chain(small.map(|facet| facet.corners.map(|p| 10.0 * p))),
    )
}

/// Rays from anywhere in the hall to a point near an edge of one of these facets.
fn rays(facets: &[Facet], n: u32) -> Vec<Ray> {
    let mut rng = pcg::stream(21, 0);
    let ray = |_| {
        let mut one = || rng.random::<f32>();
        let from = 10.0 * vec3(one(), one(), one());
        let [a, b, _] = facets[(one() * facets.len() as f32) as usize % facets.len()].corners;
        let near = 0.004 * (vec3(one(), one(), one()) - 0.5);
        let to = a.lerp(b, one()) + near;
        Ray::new(from, Dir3::new_or(to - from, Dir3::X))
    };
    (0..n).map(ray).collect()
}

/// Places in leaves.
fn places(tree: &WideBvh) -> usize {
    let leaves = wide_bvh::tree(tree).leaves().iter();
    leaves.map(|leaf| leaf.facets().count()).sum()
}

#[test]
fn ropes_are_cut_and_a_soup_is_not() {
    let facets = hall(100, 4000);
    let (n, tree) = (facets.len(), WideBvh::new(facets));
    assert_eq!(tree.validate(), Ok(()));
    assert!(
        (n + n / 2..=2 * n).contains(&places(&tree)),
        "{} places for {n} facets: ropes are in many leaves, and all are in at most two on average",
        places(&tree)
    );
    assert_eq!(places(&WideBvh::new(soup(4000, 1).facets())), 4000);
}

#[test]
fn a_tree_with_cuts_answers_as_the_list_does() {
    let facets = hall(100, 500);
    let (tree, list) = (WideBvh::new(facets.clone()), List::new(facets.clone()));
    let mut hits = 0;
    for ray in rays(&facets[..100 * ROPE], 4000) {
        let expected = list.closest(&ray, Interval::AHEAD);
        assert_eq!(tree.closest(&ray, Interval::AHEAD), expected, "{ray:?}");
        assert_eq!(
            tree.any(&ray, Interval::AHEAD),
            expected.is_some(),
            "{ray:?}"
        );
        hits += usize::from(expected.is_some());
    }
    assert!(hits > 1500, "only {hits} of 4000 rays hit");
}

#[test]
fn cuts_save_half_of_the_tests() {
    let facets = hall(100, 4000);
    let trees = [
        WideBvh::new(facets.clone()),
        WideBvh::build(facets.clone(), Method::Fine),
    ];
    let [cut, whole] = trees.map(|tree| {
        let mut tests = Tests::default();
        for ray in rays(&facets[..100 * ROPE], 1000) {
            tree.closest_counted(&ray, Interval::AHEAD, &mut tests);
        }
        tests
    });
    assert!(
        2 * cut.shapes < whole.shapes && 3 * cut.boxes < 2 * whole.boxes,
        "{cut:?} with cuts, and {whole:?} without: a third and a half were measured"
    );
}

#[test]
fn few_items_are_split_as_by_the_sweep() {
    for n in 2..=32 {
        let boxes = soup(n, 1).facets().into_iter().map(|facet| facet.bounds());
        let items: Vec<_> = boxes.enumerate().map(|(i, b)| Item::new((i, &b))).collect();
        let [by_few, by_sweep] = [split_of_few, sah_split].map(|split| {
            let mut items = items.clone();
            let split = split(&mut items, &COST);
            let order: Vec<_> = items.iter().map(|item| item.index).collect();
            (split, order)
        });
        assert_eq!(by_few, by_sweep, "{n} items");
    }
}
