//! The teapot in the stadium: the camera that looks at the teapot, and what each pixel costs.

use crate::kit::chart::{Chart, Corner};
use crate::kit::numbers::whole;
use crate::kit::palette::{BLUE, VERMILION};
use crate::kit::{axis::Axis, figure::Figure, sheet::Sheet};
use crate::shared::heat::{Heat, heat, with_scale};
use glam::{Vec3, vec3};
use plotters::style::Color;
use raybook::accel::grid::Grid;
use raybook::accel::two_level_grid::{TwoLevelGrid, build::Densities};
use raybook::camera::Camera;
use raybook::camera::pinhole::{LookAtError, Pinhole};
use raybook::render::film::Film;
use raybook::scene::stadium::Stadium;
use raybook::shape::mesh::{Facet, Mesh};

/// A camera that looks down at the teapot, with the seats behind it.
///
/// # Errors
/// Never: the directions are fixed.
pub fn camera(aspect: f32) -> Result<Pinhole, LookAtError> {
    let (eye, toward) = (vec3(0.42, 0.33, 0.66), vec3(0.03, 0.17, 0.0));
    Pinhole::look_at(eye, toward, Vec3::Y, 0.035, aspect)
}

/// The heat maps of a uniform grid and of two two-level grids, the second with its λ.
///
/// # Errors
/// If the labels cannot be drawn.
pub fn maps(
    film: &Film,
    camera: &Pinhole,
    stadium: &Stadium,
    grid: &Grid<Facet>,
    (density, fine): (f32, &TwoLevelGrid<Facet>),
) -> Sheet {
    let usual = TwoLevelGrid::of_facets(stadium.mesh.facets());
    let ray = |place| camera.central_ray(place);
    let row = |name: &str, heat: &Heat| {
        let maps = [heat.of_boxes("cells"), heat.of_triangles()];
        maps.map(|(label, map)| (format!("{name}: {label}"), map))
    };
    let rows = [
        row("grid", &heat(film, ray, grid)),
        row("two levels, λ = 1/8", &heat(film, ray, &usual)),
        row(
            &format!("two levels, λ = {density}"),
            &heat(film, ray, fine),
        ),
    ];
    with_scale(2, &rows.concat())
}

/// A two-level grid of a mesh with `coarse` coarse cells per triangle.
pub fn two_levels(mesh: &Mesh, coarse: f32) -> TwoLevelGrid<Facet> {
    let densities = Densities {
        coarse,
        ..Densities::USUAL
    };
    TwoLevelGrid::of_facets_with(mesh.facets(), densities)
}

/// What a ray costs with more and more coarse cells.
///
/// # Errors
/// What plotters reports.
pub fn densities(film: &Film, camera: &Pinhole, stadium: &Stadium) -> Figure {
    let counts = [64, 32, 16, 8, 4, 2, 1].map(|triangles| {
        let coarse = 1.0 / triangles as f32;
        let grid = two_levels(&stadium.mesh, coarse);
        let map = heat(film, |place| camera.central_ray(place), &grid);
        let mean = |sum: u64| sum as f64 / map.rays() as f64;
        (
            f64::from(coarse),
            [mean(map.tests().boxes), mean(map.tests().shapes)],
        )
    });
    let highest = counts
        .iter()
        .flat_map(|(_, tests)| tests)
        .fold(0.0_f64, |a, &b| a.max(b));
    let mut chart = Chart::new(
        Axis::log2(1.0 / 64.0..1.0)
            .named("λ: coarse cells per triangle")
            .format(|v| {
                if v < 1.0 {
                    format!("1/{:.0}", 1.0 / v)
                } else {
                    "1".to_owned()
                }
            }),
        Axis::log(1.0..4.0 * highest).named("per ray").format(whole),
    )
    .titled("How many coarse cells?")
    .legend(Corner::UpperLeft);
    for (i, name, colour) in [
        (0, "cells visited", BLUE),
        (1, "triangles tested", VERMILION),
    ] {
        let points = counts.map(|(coarse, tests)| (coarse, tests[i]));
        chart.line(points, colour.stroke_width(5)).named(name);
        chart.dots(points, 9, colour.filled());
    }
    chart.figure(900, 560)
}
