//! How the work of a ray grows with the number of triangles: counts, which are the same on every machine.

use glam::Vec3;
use rand::RngExt;
use raybook::accel::{
    Accel, Tests, bvh::Bvh, grid::Grid, list::List, octree::Octree, two_level_grid::TwoLevelGrid,
    wide_bvh::WideBvh,
};
use raybook::math::{dir3::Dir3, interval::Interval, pcg, ray::Ray};
use raybook::scene::soup;
use raybook::shape::mesh::Facet;
use raybook_common::statistics::slope;
use std::fmt::Write;
use std::time::Instant;

/// Rays through the soup, the same for every size.
const RAYS: usize = 2000;

/// The list, which asks every shape, goes no further.
const LIST: u32 = 100_000;

/// What came of one structure at one size.
struct Point {
    structure: &'static str,
    triangles: u32,
    tests: Tests,
    build: f64,
    bytes: usize,
}

/// The rows of `scaling.csv`, and below them, as comments, the exponents: steps (boxes and shapes tested) grow with the number of
/// triangles to this power, fitted by least squares, with two standard errors.
pub(crate) fn scaling(largest: u32) -> String {
    let mut points = Vec::new();
    let sizes = (0..).map(|i| (100.0 * 10_f64.powf(0.5 * f64::from(i))).round() as u32);
    for n in sizes.take_while(|&n| n <= largest) {
        let facets = soup::soup(n, 1).facets();
        let mut add = |structure, point: (Tests, f64, usize)| {
            let (tests, build, bytes) = point;
            points.push(Point {
                structure,
                triangles: n,
                tests,
                build,
                bytes,
            });
        };
        if n <= LIST {
            add("List", count(&facets, List::new, |_| size_of_val(&*facets)));
        }
        add("Grid", count(&facets, Grid::of_facets, Grid::bytes));
        add(
            "TwoLevelGrid",
            count(&facets, TwoLevelGrid::of_facets, TwoLevelGrid::bytes),
        );
        add("Octree", count(&facets, Octree::of_facets, Octree::bytes));
        add("Bvh", count(&facets, Bvh::new, Bvh::bytes));
        add("WideBvh", count(&facets, WideBvh::new, WideBvh::bytes));
    }
    let mut text = String::from("structure,triangles,boxes,shapes,build_s,bytes_per_triangle\n");
    points.sort_by_key(|point| point.structure); // stable: the sizes stay in order
    for point in &points {
        let Point {
            structure,
            triangles,
            tests,
            build,
            bytes,
        } = point;
        let [boxes, shapes] = [tests.boxes, tests.shapes].map(|n| n as f64 / RAYS as f64);
        let bytes = *bytes as f64 / f64::from(*triangles);
        let _ = writeln!(
            text,
            "{structure},{triangles},{boxes:.2},{shapes:.2},{build:.4},{bytes:.1}"
        );
    }
    for of_one in points.chunk_by(|a, b| a.structure == b.structure) {
        let logs = of_one.iter().map(|point| {
            let steps = (point.tests.boxes + point.tests.shapes) as f64;
            (f64::from(point.triangles).ln(), steps.ln())
        });
        let (exponent, error) = slope(&logs.collect::<Vec<_>>());
        let _ = writeln!(
            text,
            "# {}: steps grow as N^({exponent:.3} ± {:.3})",
            of_one[0].structure,
            2.0 * error
        );
    }
    text
}

/// The steps of all rays, the seconds of the build, and its bytes.
fn count<A: Accel<Facet>>(
    facets: &[Facet],
    build: impl Fn(Vec<Facet>) -> A,
    bytes: impl Fn(&A) -> usize,
) -> (Tests, f64, usize) {
    let start = Instant::now();
    let accel = build(facets.to_vec());
    let seconds = start.elapsed().as_secs_f64();
    let mut rng = pcg::stream(9, 0);
    let mut at = || Vec3::from_array(std::array::from_fn(|_| rng.random::<f32>()));
    let mut tests = Tests::default();
    for _ in 0..RAYS {
        let (from, to) = (3.0 * at() - 1.0, at());
        let ray = Ray::new(from, Dir3::new_or(to - from, Dir3::X));
        accel.closest_counted(&ray, Interval::AHEAD, &mut tests);
    }
    (tests, seconds, bytes(&accel))
}
