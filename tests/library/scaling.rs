//! How the work of a ray grows with the number of triangles, by counts. The list takes N steps; all others far fewer.

use glam::Vec3;
use rand::RngExt;
use raybook::accel::{
    Accel, Tests, bvh::Bvh, grid::Grid, list::List, octree::Octree, two_level_grid::TwoLevelGrid,
    wide_bvh::WideBvh,
};
use raybook::math::{dir3::Dir3, interval::Interval, pcg, ray::Ray};
use raybook::scene::soup::soup;
use raybook::shape::mesh::Facet;
use raybook_common::statistics::slope;

/// Triangles of the soups: each ten times as many as the one before.
const SIZES: [u32; 4] = [100, 1_000, 10_000, 100_000];

/// The power of N to which boxes and shapes tested grow, fitted by least squares; `largest` ends the sizes.
fn exponent<A: Accel<Facet>>(largest: u32, build: impl Fn(Vec<Facet>) -> A) -> f64 {
    let steps = |n: u32| {
        let accel = build(soup(n, 1).facets());
        let mut rng = pcg::stream(9, 0);
        let mut at = || Vec3::from_array(std::array::from_fn(|_| rng.random::<f32>()));
        let mut tests = Tests::default();
        for _ in 0..300 {
            let (from, to) = (3.0 * at() - 1.0, at());
            let ray = Ray::new(from, Dir3::new_or(to - from, Dir3::X));
            accel.closest_counted(&ray, Interval::AHEAD, &mut tests);
        }
        (
            f64::from(n).ln(),
            ((tests.boxes + tests.shapes) as f64).ln(),
        )
    };
    let points: Vec<_> = SIZES
        .into_iter()
        .filter(|&n| n <= largest)
        .map(steps)
        .collect();
    slope(&points).0
}

#[track_caller]
fn grows(exponent: f64, least: f64, most: f64) {
    assert!(
        (least..most).contains(&exponent),
        "steps grow as N^{exponent}, and not with an exponent from {least} to {most}"
    );
}

#[test]
fn the_list_is_linear() {
    grows(exponent(10_000, List::new), 0.999, 1.001);
}

/// An empty grid has N^⅓ cells on a ray's way; in this soup a ray is stopped after a few of them, however small they are.
#[test]
fn a_grid_takes_less_than_the_cube_root() {
    grows(exponent(100_000, Grid::of_facets), 0.05, 0.33);
}

#[test]
fn a_two_level_grid_takes_less_than_the_cube_root() {
    grows(exponent(100_000, TwoLevelGrid::of_facets), 0.05, 0.33);
}

#[test]
fn an_octree_takes_less_than_the_cube_root() {
    grows(exponent(100_000, Octree::of_facets), 0.05, 0.33);
}

/// The logarithm, and the overlap of boxes.
#[test]
fn trees_of_boxes_take_less_than_the_cube_root() {
    grows(exponent(100_000, Bvh::new), 0.05, 0.33);
    grows(exponent(100_000, WideBvh::new), 0.05, 0.33);
}
