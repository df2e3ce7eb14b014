//! A coarse grid, each of whose cells is a grid of its own: a fine grid where there are many triangles, and no
//! grid where there are none. The uniform grid lacks this when a teapot stands in a stadium.
//!
//! New: accel/order.rs accel/two_level_grid/mod.rs accel/two_level_grid/levels.rs accel/two_level_grid/refine.rs
//! New: accel/two_level_grid/build.rs accel/two_level_grid/walk.rs accel/two_level_grid/validate.rs

mod letters;
mod nested_cells;
pub mod teapot_in_stadium;

use crate::kit::chapter;
use crate::kit::stage::{Drawn, Stage};
use crate::shared::own_mesh::{self, MeshKnob};
use crate::shared::{
    daylight::shade, outdoors::sky, showroom::small, speeds::rays_a_second, stadium_figure::paint,
};
use clap::Args;
use raybook::accel::Accel;
use raybook::accel::grid::Grid;
use raybook::camera::Camera;
use raybook::math::interval::Interval;
use raybook::render::film::Film;
use raybook::scene::stadium::stadium;
use raybook::shape::mesh::Mesh;
use std::process::ExitCode;
use teapot_in_stadium::{camera, densities, maps, two_levels};

/// What the pictures depend on.
#[derive(Args, Clone, Debug)]
pub struct Knobs {
    #[command(flatten)]
    own: MeshKnob,
    /// Density λ of the coarse grid: coarse cells per triangle, in `heat`
    #[arg(long, value_name = "0.001..10 cells", default_value = "1")]
    density: f32,
}

/// Draws the chapter's pictures.
///
/// # Errors
/// If a picture cannot be drawn or written.
pub fn draw(stage: &Stage, knobs: &Knobs) -> Drawn {
    let density = knobs.density;
    if let Some(path) = &knobs.own.mesh {
        let levels = |mesh: &Mesh| two_levels(mesh, density);
        return own_mesh::draw(stage, path, levels, "cells visited");
    }
    let stadium = stadium(5);
    let triangles = stadium.mesh.triangles().len();
    let film = stage.film_of(640, 6, 1.6);
    let camera = camera(film.aspect())?;
    let fine = two_levels(&stadium.mesh, density);
    if stage.wants("picture") {
        let caption = format!(
            "A teapot in a stadium of {triangles} triangles, and its shadow. The cells of a uniform grid have a size that suits the seats, and one or two of these cells hold the whole teapot."
        );
        let picture = film.refine(|place, _| {
            let ray = camera.central_ray(place);
            match fine.closest(&ray, Interval::AHEAD) {
                Some((_, hit)) => {
                    let at = stadium.mesh.surface(&ray, &hit);
                    shade(&at, paint(stadium.part(hit.id)), &ray, &fine)
                }
                None => sky(ray.direction),
            }
        });
        stage.picture("picture", &caption, &picture)?;
    }

    stage.drawing("letters", letters::CAPTION, letters::draw)?;
    if stage.wants("walk") {
        let caption = "A two-level grid in the plane: thick lines are the borders of coarse cells, thin lines are those of fine \
            cells. The number of fine cells in a coarse cell depends on its discs; an empty coarse cell has none. The numbers are \
            the ray's steps; small cells have no room for them.";
        stage.diagram("walk", caption, &nested_cells::diagram()?)?;
    }

    let tile = small(&film);
    let grid = Grid::of_facets(stadium.mesh.facets());
    let tiny = Film {
        width: tile.width / 4,
        height: tile.height / 4,
        ..tile
    };
    let ray = |place| camera.central_ray(place);
    if stage.wants("heat") {
        let caption = format!(
            "What each pixel's ray costs, with the same scale for all. λ is the number of coarse cells per triangle. One thread of \
            this machine answers {} with the uniform grid, and {} with two levels and λ = {density}.",
            rays_a_second(&tiny, ray, &grid),
            rays_a_second(&tile, ray, &fine)
        );
        stage.figure(
            "heat",
            &caption,
            &maps(&tile, &camera, &stadium, &grid, (density, &fine))?,
        )?;
    }

    if !stage.wants("densities") {
        return Ok(());
    }
    let caption = "The same view with more and more coarse cells: each cell holds a smaller part of the teapot, but a ray walks through more cells. Where triangles are spread evenly, fewer coarse cells are faster.";
    stage.diagram("densities", caption, &densities(&tiny, &camera, &stadium)?)
}

/// The chapter's binary.
pub fn main() -> ExitCode {
    chapter::run("ch09_two_level_grid")
}
