//! Space cut into equal cells, each with a list of the triangles in it: a ray is tested only against the triangles in
//! the cells that it passes through, one cell after the other, and stops at the first hit.
//!
//! New: accel/bounded.rs accel/ray_box.rs accel/lattice.rs accel/margin.rs accel/overlap.rs accel/walk.rs
//! New: accel/grid/mod.rs accel/grid/build.rs accel/grid/lists.rs accel/grid/mailbox.rs accel/grid/resolution.rs accel/grid/validate.rs
//! New: scene/soup.rs scene/stadium.rs scene/terrain.rs

mod grid_costs;
mod letters;
mod sizes;
mod teapots;
mod walk_figure;

use crate::kit::stage::{Drawn, Stage};
use crate::kit::{chapter, numbers::grouped, palette};
use crate::shared::daylight::{Paint, shade};
use crate::shared::own_mesh::{self, MeshKnob};
use crate::shared::{growth, heat, outdoors::sky, showroom, stadium_figure};
use clap::Args;
use glam::{Vec3, vec3};
use raybook::accel::{Accel, grid::Grid};
use raybook::camera::Camera;
use raybook::camera::pinhole::Pinhole;
use raybook::image::rgb::Rgb;
use raybook::inside::grid::{grid_resolution, lattice};
use raybook::math::interval::Interval;
use raybook::scene::stadium::stadium;
use raybook::shape::{mesh::Mesh, teapot};
use std::process::ExitCode;
use teapots::teapots;

/// What the pictures depend on.
#[derive(Args, Clone, Debug)]
pub struct Knobs {
    #[command(flatten)]
    own: MeshKnob,
    /// Density λ of the grid: cells per triangle, in `heat`
    #[arg(long, value_name = "0.001..300 cells", default_value = "5")]
    density: f32,
}

/// Draws the chapter's pictures.
///
/// # Errors
/// If a picture cannot be drawn or written.
pub fn draw(stage: &Stage, knobs: &Knobs) -> Drawn {
    let grid_of = |mesh: &Mesh| {
        let facets = mesh.facets();
        let size = mesh.bounds().size();
        let resolution = grid_resolution(size, facets.len(), knobs.density);
        Grid::of_facets_with_resolution(facets, resolution)
    };
    if let Some(path) = &knobs.own.mesh {
        return own_mesh::draw(stage, path, grid_of, "cells visited");
    }
    let film = stage.film_of(640, 8, 1.6);
    let crowd = teapots(350, 4);
    let grid = grid_of(&crowd.mesh);
    let (from, to) = (vec3(8.0, 52.0, 92.0), vec3(0.0, 0.0, 10.0));
    let camera = Pinhole::look_at(from, to, Vec3::Y, 0.035, film.aspect())?;
    if stage.wants("picture") {
        let paint = |id| {
            let colour = |out| palette::viridis(1.0 - out);
            Paint {
                colour: crowd.teapot(id).map_or(Rgb::gray(0.6), colour),
                round: crowd.teapot(id).is_some(),
            }
        };
        let picture = film.refine(|place, _| {
            let ray = camera.central_ray(place);
            match grid.closest(&ray, Interval::AHEAD) {
                Some((_, hit)) => {
                    let at = crowd.mesh.surface(&ray, &hit);
                    shade(&at, paint(hit.id), &ray, &grid)
                }
                None => sky(ray.direction),
            }
        });
        let cells = lattice(&grid).resolution;
        let caption = format!(
            "{} triangles in a grid of {} × {} × {} cells. A list would test each ray against all triangles.",
            grouped(crowd.mesh.triangles().len() as f64),
            cells.x,
            cells.y,
            cells.z
        );
        stage.picture("picture", &caption, &picture)?;
    }

    stage.drawing("letters", letters::CAPTION, letters::draw)?;
    stage.drawing("sizes", sizes::CAPTION, sizes::draw)?;
    if stage.wants("walk") {
        let caption = "The cells through which a ray passes, numbered in order up to the first hit. The ray is tested only against \
            the triangles in these cells, two of six, and once against each. The blue cells hold triangles too, but the ray does not \
            pass through them.";
        stage.diagram("walk", caption, &walk_figure::diagram()?)?;
    }

    let small = showroom::small(&stage.film_of(800, 8, 1.6));
    if stage.wants("heat") {
        let heat = heat::heat(&small, |place| camera.central_ray(place), &grid);
        let caption = "What each ray of the picture costs. A ray visits many cells, and most of them are empty. The triangle tests come at the end, around the hit.";
        stage.figure("heat", caption, &heat.figure("cells visited")?)?;
    }

    if stage.wants("resolution") {
        let costs = grid_costs::measure(&teapot::mesh(20));
        let caption = format!(
            "The same {} rays in grids of more and more cells: fewer triangles are tested, and more cells are visited. The fastest \
            of these grids answers {:.1} million rays per second on one thread, measured while this figure was drawn.",
            grid_costs::RAYS,
            grid_costs::rate(&costs) / 1e6
        );
        stage.diagram("resolution", &caption, &grid_costs::plot(&costs)?)?;
    }

    if stage.wants("law") {
        let caption = "A soup of N triangles, so small that most rays leave the soup at the other end. Both counts grow with the \
            cube root of N: a thousand times as many triangles cost ten times as much.";
        stage.diagram("law", caption, &growth::grid()?)?;
    }

    if !stage.wants("stadium") {
        return Ok(());
    }
    let stadium = stadium(4);
    let grid = grid_of(&stadium.mesh);
    let caption = format!(
        "The teapot in the stadium. A cell is {:.1} m wide, so the teapot and the camera are in the same cell: every ray of the \
        near view tests the whole teapot, even a ray that goes to the seats.",
        lattice(&grid).cell.x
    );
    let tiles = stadium_figure::figure(&small, &stadium, &grid, "cells visited")?;
    stage.figure("stadium", &caption, &tiles)
}

/// The chapter's binary.
pub fn main() -> ExitCode {
    chapter::run("ch08_grid")
}
