//! How the work of a ray grows with the number of triangles: counts, which are the same on every machine.

use glam::Vec3;
use plotters::prelude::{Color, RGBColor};
use rand::RngExt;
use raybook::accel::{
    Accel, Tests, bvh::Bvh, grid::Grid, list::List, octree::Octree, two_level_grid::TwoLevelGrid,
    wide_bvh::WideBvh,
};
use raybook::math::{dir3::Dir3, interval::Interval, pcg, ray::Ray};
use raybook::scene::soup;
use raybook::shape::mesh::Facet;
use raybook_chapters::kit::axis::Axis;
use raybook_chapters::kit::chart::{Chart, Corner};
use raybook_chapters::kit::figure::{Figure, figure};
use raybook_chapters::kit::palette::{BLUE, GREEN, INK, ORANGE, PURPLE, VERMILION};
use raybook_chapters::lab::legend::power_of_ten;
use raybook_common::statistics::slope;
use std::fmt::Write;
use std::time::Instant;

/// Rays through the soup, the same for every size.
const RAYS: usize = 2000;

/// The list, which asks every shape, goes no further.
const LIST: u32 = 100_000;

/// What came of one structure at one size.
#[derive(Clone, Copy)]
pub(crate) struct Point {
    structure: &'static str,
    triangles: f64,
    /// Boxes tested, in the mean over the rays.
    boxes: f64,
    /// The same of triangles.
    shapes: f64,
    /// Both.
    steps: f64,
    /// Seconds.
    build: f64,
    /// Bytes per triangle.
    bytes: f64,
}

/// What came of the structures at all sizes from a hundred triangles to `largest`, structure by structure.
pub(crate) fn measure(largest: u32) -> Vec<Point> {
    let mut points = Vec::new();
    let sizes = (0..).map(|i| (100.0 * 10_f64.powf(0.5 * f64::from(i))).round() as u32);
    for n in sizes.take_while(|&n| n <= largest) {
        let facets = soup::soup(n, 1).facets();
        let mut add = |structure, point: (Tests, f64, usize)| {
            let (tests, build, bytes) = point;
            let steps = (tests.boxes + tests.shapes) as f64 / RAYS as f64;
            points.push(Point {
                structure,
                triangles: f64::from(n),
                boxes: tests.boxes as f64 / RAYS as f64,
                shapes: tests.shapes as f64 / RAYS as f64,
                steps,
                build,
                bytes: bytes as f64 / f64::from(n),
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
    points.sort_by_key(|point| point.structure); // stable: the sizes stay in order
    points
}

/// The points of one structure after the other.
fn structures(points: &[Point]) -> impl Iterator<Item = &[Point]> {
    points.chunk_by(|a, b| a.structure == b.structure)
}

/// The power of the number of triangles to which the steps of one structure grow, fitted by least squares, and two standard errors.
fn exponent(of_one: &[Point]) -> (f64, f64) {
    let logs = of_one
        .iter()
        .map(|point| (point.triangles.ln(), point.steps.ln()));
    let (exponent, error) = slope(&logs.collect::<Vec<_>>());
    (exponent, 2.0 * error)
}

/// The rows of `scaling.csv`, and below them, as comments, the exponents.
pub(crate) fn table(points: &[Point]) -> String {
    let mut text = String::from("structure,triangles,boxes,shapes,build_s,bytes_per_triangle\n");
    for point in points {
        let Point {
            structure,
            triangles,
            boxes,
            shapes,
            build,
            bytes,
            ..
        } = point;
        let _ = writeln!(
            text,
            "{structure},{triangles},{boxes:.2},{shapes:.2},{build:.4},{bytes:.1}"
        );
    }
    for of_one in structures(points) {
        let (exponent, error) = exponent(of_one);
        let name = of_one[0].structure;
        let _ = writeln!(
            text,
            "# {name}: steps grow as N^({exponent:.3} ± {error:.3})"
        );
    }
    text
}

/// Colours of the structures, in the order of their names.
const COLOURS: [RGBColor; 6] = [BLUE, GREEN, INK, PURPLE, ORANGE, VERMILION];

/// Steps, memory and the time of the build against the number of triangles, side by side. The legend tells the exponents of the steps.
///
/// # Errors
/// What plotters reports.
pub(crate) fn picture(points: &[Point]) -> Figure {
    let most = |of: fn(&Point) -> f64| points.iter().map(of).fold(0.0, f64::max);
    let least = |of: fn(&Point) -> f64| points.iter().map(of).fold(f64::INFINITY, f64::min);
    let log = |of| Axis::log(0.5 * least(of)..2.0 * most(of)).format(power_of_ten);
    let from_zero = |of| Axis::linear(0.0..1.1 * most(of));
    let steps: fn(&Point) -> f64 = |point| point.steps;
    let bytes: fn(&Point) -> f64 = |point| point.bytes;
    let build: fn(&Point) -> f64 = |point| point.build;
    let panels = [
        (
            log(steps).named("boxes and triangles tested per ray"),
            steps,
        ),
        (from_zero(bytes).named("bytes per triangle"), bytes),
        (log(build).named("seconds to build"), build),
    ];
    let charts = panels.map(|(y, of)| {
        let mut chart = Chart::new(log(|point| point.triangles).named("triangles"), y);
        for (of_one, colour) in structures(points).zip(COLOURS) {
            let places = || of_one.iter().map(|point| (point.triangles, of(point)));
            let (exponent, error) = exponent(of_one);
            let name = format!(
                "{}: steps ∝ N^({exponent:.2} ± {error:.2})",
                of_one[0].structure
            );
            chart
                .line(places(), colour.stroke_width(6))
                .named(&name)
                .dots(places(), 8, colour.filled());
        }
        chart
    });
    let [steps, bytes, build] = charts;
    let charts = [steps, bytes.legend(Corner::LowerLeft), build]; // where no curve is
    figure(1800, 640, |canvas| {
        let parts = canvas.split_evenly((1, charts.len()));
        let mut both = charts.iter().zip(parts);
        both.try_for_each(|(chart, part)| chart.draw(&part))
    })
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
