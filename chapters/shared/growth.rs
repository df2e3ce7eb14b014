//! How the work of a search grows with the number of triangles, on two logarithmic axes: a power of N is a straight line.

use crate::kit::lines::grouped;
use crate::kit::{figure::FONT, figure::figure};
use crate::kit::{palette::BLUE, palette::FAINT, palette::INK, palette::VERMILION};
use crate::shared::{law::Reach, law::mean_tests};
use plotters::prelude::{
    ChartBuilder, Circle, Color, IntoFont, IntoLogRange, LineSeries, RGBColor, Text,
};
use raybook::accel::{bvh::Bvh, grid::Grid};
use raybook::image::Image;
use std::error::Error;

/// Tests per ray against triangles: the list, the tree.
///
/// # Errors
/// What plotters reports.
pub fn list_and_tree() -> Result<Image, Box<dyn Error>> {
    let sizes = [
        100, 300, 1000, 3000, 10_000, 30_000, 100_000, 200_000, 400_000,
    ];
    let tree = sizes.map(|n| {
        let tests = mean_tests(n, Reach::Inside, Bvh::new);
        (f64::from(n), tests[0] + tests[1])
    });
    let list = sizes.map(|n| (f64::from(n), f64::from(n)));
    let curves = [
        Curve::of(&list, "list: N", VERMILION, (12_000.0, 40_000.0)),
        Curve::of(&tree, "tree: log N", BLUE, (12_000.0, 90.0)),
    ];
    plot("boxes and triangles tested per ray", &curves)
}

/// Cells and tests of a ray across a grid, against triangles.
///
/// # Errors
/// What plotters reports.
pub fn grid() -> Result<Image, Box<dyn Error>> {
    let sizes = [100, 1000, 10_000, 100_000, 1_000_000];
    let counts = sizes.map(|n| {
        let tests = mean_tests(n, Reach::Across, Grid::of_facets);
        (f64::from(n), tests)
    });
    let [cells, tests] = [0, 1].map(|i| counts.map(|(n, count)| (n, count[i])));
    // Between the two, so that either can be compared with it.
    let between = (cells[0].1 * tests[0].1).sqrt();
    let cube_root = sizes
        .map(f64::from)
        .map(|n| (n, between * (n / 100.0).cbrt()));
    let curves = [
        Curve {
            is_guide: true,
            ..Curve::of(&cube_root, "∛N", INK, (15_000.0, 1.7 * cube_root[2].1))
        },
        Curve::of(&cells, "cells visited", BLUE, (200.0, 3.4 * cells[0].1)),
        Curve::of(&tests, "triangles tested", VERMILION, (3000.0, tests[1].1)),
    ];
    plot("per ray", &curves)
}

/// A curve, and where its name stands.
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

fn plot(y: &str, curves: &[Curve]) -> Result<Image, Box<dyn Error>> {
    let points = || curves.iter().flat_map(|curve| curve.points);
    let least = |of: fn(&(f64, f64)) -> f64| points().map(of).fold(f64::INFINITY, f64::min);
    let most = |of: fn(&(f64, f64)) -> f64| points().map(of).fold(0.0, f64::max);
    let x_range = 0.8 * least(|p| p.0)..1.25 * most(|p| p.0);
    let y_range = 10_f64.powf(least(|p| p.1).log10().floor())..1.25 * most(|p| p.1);
    figure(960, 560, |canvas| {
        let mut chart = ChartBuilder::on(canvas)
            .margin(40)
            .margin_right(90)
            .x_label_area_size(110)
            .y_label_area_size(200)
            .build_cartesian_2d(x_range.log_scale(), y_range.log_scale())?;
        let font = |size: i32| (FONT, size).into_font().color(&INK);
        chart
            .configure_mesh()
            .light_line_style(FAINT.mix(0.0))
            .bold_line_style(FAINT.mix(0.6))
            .axis_style(INK)
            .label_style(font(34))
            .axis_desc_style(font(38))
            .x_desc("triangles")
            .y_desc(y)
            .x_label_formatter(&|n| grouped(*n))
            .y_label_formatter(&|n| grouped(*n))
            .draw()?;
        for curve in curves {
            let style = curve
                .colour
                .stroke_width(if curve.is_guide { 3 } else { 6 });
            let points = || curve.points.iter().copied();
            chart.draw_series(LineSeries::new(points(), style))?;
            if !curve.is_guide {
                let dot = |p| Circle::new(p, 9, curve.colour.filled());
                chart.draw_series(points().map(dot))?;
            }
            let style = (FONT, 44).into_font().color(&curve.colour);
            chart.draw_series([Text::new(curve.name.to_owned(), curve.at, style)])?;
        }
        Ok(())
    })
}
