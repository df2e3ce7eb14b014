//! What a ray costs in a grid, against the grid's resolution.

use crate::kit::axis::Axis;
use crate::kit::chart::{Chart, Corner};
use crate::kit::figure::{CENTRE, Figure};
use crate::kit::numbers::grouped;
use crate::kit::palette::{BLUE, GREEN, INK, VERMILION};
use crate::shared::showroom::Showroom;
use glam::vec2;
use plotters::style::{Color, RGBColor};
use raybook::accel::grid::Grid;
use raybook::accel::{Accel, Tests};
use raybook::inside::grid::grid_resolution;
use raybook::math::interval::Interval;
use raybook::shape::mesh::Mesh;
use std::hint::black_box;
use std::time::Instant;

/// Cells per triangle, λ.
const DENSITIES: [f32; 12] = [
    0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0, 300.0,
];

/// Number of rays for each grid.
pub(super) const RAYS: usize = 600;

/// Minimum number of rounds in which each grid is timed.
const ROUNDS: u32 = 3;
/// Minimum time for which each grid is timed, in seconds: a fast grid gets more rounds.
const ENOUGH: f64 = 0.01;

/// What a ray costs, on average, in a grid of a given density, in cells per triangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cost {
    /// λ.
    pub density: f32,
    /// Nanoseconds, the best of several rounds.
    pub time: f32,
    /// Cells visited.
    pub cells: f32,
    /// Triangles tested.
    pub triangles: f32,
}

/// The costs over the densities of a showroom's rays, measured now.
pub(super) fn measure(mesh: &Mesh) -> Vec<Cost> {
    let room = Showroom::around(mesh, 1.6);
    // Evenly over the picture; rays that follow each other are not neighbours.
    let place = |i: usize| vec2(i as f32 * 0.618_034 % 1.0, i as f32 / RAYS as f32);
    let rays: Vec<_> = (0..RAYS).map(|i| room.ray(place(i))).collect();
    let per_ray = |x: f64| (x / RAYS as f64) as f32;
    let cost = |&density: &f32| {
        let facets = mesh.facets();
        let resolution = grid_resolution(mesh.bounds().size(), facets.len(), density);
        let grid = Grid::of_facets_with_resolution(facets, resolution);
        let mut tests = Tests::default();
        for ray in &rays {
            grid.closest_counted(ray, Interval::AHEAD, &mut tests);
        }
        let (mut best, begin) = (f64::INFINITY, Instant::now());
        for round in 0.. {
            let start = Instant::now();
            if round >= ROUNDS && begin.elapsed().as_secs_f64() > ENOUGH {
                break;
            }
            for ray in &rays {
                black_box(grid.closest(ray, Interval::AHEAD));
            }
            best = best.min(start.elapsed().as_secs_f64());
        }
        Cost {
            density,
            time: per_ray(1e9 * best),
            cells: per_ray(tests.boxes as f64),
            triangles: per_ray(tests.shapes as f64),
        }
    };
    DENSITIES.iter().map(cost).collect()
}

/// Rays per second in the grid that takes the least time.
pub(super) fn rate(costs: &[Cost]) -> f32 {
    best(costs).map_or(0.0, |best| 1e9 / best.time)
}

/// The cost of the grid that takes the least time.
fn best(costs: &[Cost]) -> Option<&Cost> {
    costs.iter().min_by(|a, b| a.time.total_cmp(&b.time))
}

/// The costs as lines, with the least time marked.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn plot(costs: &[Cost]) -> Figure {
    type Curve = (&'static str, RGBColor, fn(&Cost) -> f32);
    let curves: [Curve; 3] = [
        ("nanoseconds", INK, |cost| cost.time),
        ("triangles tested", VERMILION, |cost| cost.triangles),
        ("cells visited", BLUE, |cost| cost.cells),
    ];
    let most = costs
        .iter()
        .map(|c| c.time.max(c.triangles))
        .fold(10.0, f32::max);
    let mut chart = Chart::new(
        Axis::log(0.0007..450.0).named("λ: cells per triangle"),
        Axis::log(0.7..2.0 * most).named("per ray").format(grouped),
    )
    .text(33)
    .legend(Corner::UpperMiddle);
    for (name, colour, value) in curves {
        let points = || costs.iter().map(|cost| (cost.density, value(cost)));
        chart.line(points(), colour.stroke_width(5)).named(name);
        chart.dots(points(), 7, colour.filled());
    }
    if let Some(best) = best(costs) {
        let place = (best.density, best.time);
        chart.dots([place], 20, GREEN.stroke_width(6));
        for (x, y, words, colour) in [
            (best.density, 0.5 * best.time, "the least time", GREEN),
            (0.006, 30.0, "too few cells:", INK),
            (0.006, 18.0, "nearly a list", INK),
            (30.0, 30.0 * best.time, "too many cells:", INK),
            (30.0, 18.0 * best.time, "steps through empty cells", INK),
        ] {
            chart.label(CENTRE, (x, y), words, colour);
        }
    }
    chart.figure(960, 560)
}
