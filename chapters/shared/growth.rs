//! How the work of a search grows with the number of triangles, on two logarithmic axes: a power of N is a straight line.

use crate::kit::axis::Axis;
use crate::kit::chart::Chart;
use crate::kit::figure::{Figure, LEFT};
use crate::kit::numbers::grouped;
use crate::kit::palette::{BLUE, INK, VERMILION};
use crate::shared::law::{Reach, at_sizes};
use plotters::prelude::{Color, RGBColor};
use raybook::accel::{bvh::Bvh, grid::Grid};

/// Tests per ray against the number of triangles, for the list and the tree.
///
/// # Errors
/// What plotters reports.
pub fn list_and_tree() -> Figure {
    let sizes = [100, 300, 1000, 3000, 10_000, 30_000, 100_000, 400_000];
    let tree = at_sizes(&sizes, Reach::Inside, Bvh::new);
    let tree: Vec<_> = tree
        .iter()
        .map(|(n, tests)| (*n, tests[0] + tests[1]))
        .collect();
    let list = sizes.map(|n| (f64::from(n), f64::from(n)));
    let curves = [
        Curve::of(&list, "list: N", VERMILION, (12_000.0, 32_000.0)),
        Curve::of(&tree, "tree: log N", BLUE, (12_000.0, 75.0)),
    ];
    plot("boxes and triangles tested per ray", &curves)
}

/// Cells visited and triangles tested by a ray across a grid, against the number of triangles.
///
/// # Errors
/// What plotters reports.
pub fn grid() -> Figure {
    let sizes = [100, 1000, 10_000, 100_000, 1_000_000];
    let counts = at_sizes(&sizes, Reach::Across, Grid::of_facets);
    let [cells, tests] = [0, 1].map(|i| {
        counts
            .iter()
            .map(|(n, count)| (*n, count[i]))
            .collect::<Vec<_>>()
    });
    // Between the two curves, so that both can be compared with the law.
    let between = (cells[0].1 * tests[0].1).sqrt();
    let cube_root = sizes
        .map(f64::from)
        .map(|n| (n, between * (n / 100.0).cbrt()));
    let curves = [
        Curve {
            is_guide: true,
            ..Curve::of(&cube_root, "∛N", INK, (150_000.0, 0.8 * cube_root[3].1))
        },
        Curve::of(&cells, "cells visited", BLUE, (200.0, 3.4 * cells[0].1)),
        Curve::of(
            &tests,
            "triangles tested",
            VERMILION,
            (15_000.0, 0.6 * tests[2].1),
        ),
    ];
    plot("count per ray", &curves)
}

/// A curve, and the place of its name.
struct Curve<'a> {
    points: &'a [(f64, f64)],
    name: &'a str,
    colour: RGBColor,
    at: (f64, f64),
    /// Thin and without marks: a law to compare with.
    is_guide: bool,
}

impl<'a> Curve<'a> {
    fn of(points: &'a [(f64, f64)], name: &'a str, colour: RGBColor, at: (f64, f64)) -> Self {
        Self {
            points,
            name,
            colour,
            at,
            is_guide: false,
        }
    }
}

fn plot(y: &str, curves: &[Curve]) -> Figure {
    let points = || curves.iter().flat_map(|curve| curve.points);
    let least = |of: fn(&(f64, f64)) -> f64| points().map(of).fold(f64::INFINITY, f64::min);
    let most = |of: fn(&(f64, f64)) -> f64| points().map(of).fold(0.0, f64::max);
    let x_range = 0.8 * least(|p| p.0)..1.25 * most(|p| p.0);
    let y_range = 10_f64.powf(least(|p| p.1).log10().floor())..1.25 * most(|p| p.1);
    let mut chart = Chart::new(
        Axis::log(x_range).named("triangles").format(grouped),
        Axis::log(y_range).named(y).format(grouped),
    )
    .text(38);
    for curve in curves {
        let points = || curve.points.iter().copied();
        if curve.is_guide {
            chart.line(points(), curve.colour.stroke_width(3));
        } else {
            chart.line(points(), curve.colour.stroke_width(6)).dots(
                points(),
                9,
                curve.colour.filled(),
            );
        }
        chart.label(LEFT, curve.at, curve.name, curve.colour);
    }
    chart.figure(960, 560)
}
