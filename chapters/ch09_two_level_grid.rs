//! # Two-level grid
//!
//! A coarse grid, each of whose cells is a grid of its own: fine where there is much, absent where there is nothing. This is
//! what the uniform grid lacks when a teapot stands in a stadium.
//!
//! New: accel/order.rs accel/two_level_grid/mod.rs accel/two_level_grid/levels.rs accel/two_level_grid/refine.rs
//! New: accel/two_level_grid/build.rs accel/two_level_grid/walk.rs accel/two_level_grid/validate.rs

use glam::{Vec3, vec3};
use raybook::accel::two_level_grid::{TwoLevelGrid, build::Densities};
use raybook::accel::{Accel, grid::Grid};
use raybook::camera::pinhole::Pinhole;
use raybook::image::rgb::Rgb;
use raybook::lab::heat::{Heat, heat, with_scale};
use raybook::lab::lines::{Line, lines};
use raybook::lab::palette::{BLUE, VERMILION};
use raybook::lab::stage::{Drawn, Stage};
use raybook::lab::{chapter, nested_cells, outdoors, showroom, speed::rays_a_second, sunshine};
use raybook::math::interval::Interval;
use raybook::scene::stadium::{Part, stadium};
use std::process::ExitCode;

/// Draws the chapter's pictures.
pub(crate) fn draw(stage: &Stage) -> Drawn {
    let stadium = stadium(5);
    let facets = || stadium.mesh.facets();
    let (grid, two_levels) = (Grid::of_facets(facets()), TwoLevelGrid::of_facets(facets()));
    let film = stage.film_of(640, 4, 1.6);
    let (eye, toward) = (vec3(0.55, 0.42, 0.95), vec3(0.03, 0.22, 0.0));
    let camera = Pinhole::look_at(eye, toward, Vec3::Y, 0.035, film.aspect())?;
    let picture = film.render(|place, _| {
        let ray = camera.ray_through(place);
        let Some((_, hit)) = two_levels.closest(&ray, Interval::AHEAD) else {
            return outdoors::sky(ray.direction);
        };
        let colour = match stadium.part(hit.id) {
            Part::Teapot => Rgb::new(0.75, 0.16, 0.08),
            Part::Ground => Rgb::new(0.12, 0.33, 0.09),
            Part::Steps => Rgb::gray(0.45),
            Part::Seats => Rgb::new(0.08, 0.22, 0.55),
            Part::Roof => Rgb::gray(0.75),
        };
        let at = stadium.mesh.surface(&ray, &hit);
        sunshine::lit(colour, &at, &ray, |ray| {
            two_levels.any(ray, Interval::AHEAD)
        })
    });
    let caption = format!(
        "A teapot of {} triangles in a stadium of {}, and its shadow. The uniform grid would put all of the teapot into one or two cells.",
        32 * 5 * 5 * 2,
        stadium.mesh.triangles().len()
    );
    stage.picture("picture", &caption, &picture)?;

    let caption = "A two-level grid in the plane: thick lines part coarse cells, thin lines fine ones. Each coarse cell has as many fine ones as suit its discs, an empty one has none. The numbers are the ray's steps.";
    stage.figure("walk", caption, &nested_cells::diagram()?)?;

    let film = showroom::small(&film);
    let ray = |place| camera.ray_through(place);
    let (before, after) = (heat(&film, ray, &grid), heat(&film, ray, &two_levels));
    let maps = |heat: &Heat, name: &str| {
        [heat.of_boxes("cells"), heat.of_triangles()]
            .map(|(label, map)| (format!("{name}: {label}"), map))
    };
    let maps = [maps(&before, "grid"), maps(&after, "two levels")].concat();
    let caption = format!(
        "Cells visited and triangles tested for each pixel's ray, with the uniform grid above and two levels below. In one thread, the uniform grid answers {} here, two levels {}.",
        rays_a_second(&film, ray, &grid),
        rays_a_second(&film, ray, &two_levels)
    );
    stage.figure("heat", &caption, &with_scale(2, &maps)?)?;

    let counts = [1024, 256, 64, 16, 4, 1].map(|shapes| {
        let coarse = 1.0 / shapes as f32;
        let densities = Densities {
            coarse,
            ..Densities::USUAL
        };
        let grid = TwoLevelGrid::of_facets_with(facets(), densities);
        let map = heat(&film, ray, &grid);
        let mean = |sum: u64| sum as f64 / map.rays() as f64;
        (
            f64::from(coarse),
            mean(map.tests().boxes),
            mean(map.tests().shapes),
        )
    });
    let line = |name: &str, colour, points| Line {
        name: name.to_owned(),
        colour,
        points,
        marked: true,
    };
    let curves = [
        line(
            "cells visited",
            BLUE,
            counts.map(|(x, cells, _)| (x, cells)).to_vec(),
        ),
        line(
            "triangles tested",
            VERMILION,
            counts.map(|(x, _, tests)| (x, tests)).to_vec(),
        ),
    ];
    let plot = lines(
        "How many coarse cells?",
        "coarse cells per triangle",
        "per ray",
        &curves,
    )?;
    let caption = "The same picture with more and more coarse cells. Few coarse cells are uniform grids again; with many, a ray walks through empty ones.";
    stage.figure("densities", caption, &plot)
}

fn main() -> ExitCode {
    chapter::run("ch09_two_level_grid", draw)
}
