//! # Grid
//!
//! Space cut into equal cells, each with a list of the triangles in it: a ray asks only those in the cells that it passes
//! through, one cell after the other, and stops at the first hit.
//!
//! New: accel/bounded.rs accel/ray_box.rs accel/lattice.rs accel/margin.rs accel/overlap.rs accel/walk.rs
//! New: accel/grid/mod.rs accel/grid/build.rs accel/grid/mailbox.rs accel/grid/resolution.rs accel/grid/validate.rs
//! New: scene/soup.rs scene/terrain.rs scene/stadium.rs

use glam::{Vec3, vec3};
use raybook::accel::{Accel, grid::Grid};
use raybook::camera::pinhole::Pinhole;
use raybook::image::rgb::Rgb;
use raybook::lab::stage::{Drawn, Stage};
use raybook::lab::{chapter, heat, outdoors, showroom};
use raybook::math::{dir3::Dir3, interval::Interval};
use raybook::scene::stadium::{Part, stadium};
use std::process::ExitCode;

/// Draws the chapter's pictures.
pub(crate) fn draw(stage: &Stage) -> Drawn {
    let start = std::time::Instant::now();
    let stadium = stadium(5);
    let grid = Grid::of_facets(stadium.mesh.facets());
    println!(
        "{} {:?} {:?}",
        stadium.mesh.triangles().len(),
        grid.lattice(),
        start.elapsed()
    );
    let film = stage.film_of(640, 1, 1.6);
    let camera = Pinhole::look_at(
        vec3(0.6, 0.55, 1.1),
        vec3(0.0, 0.3, 0.0),
        Vec3::Y,
        0.035,
        film.aspect(),
    )?;
    let sun = Dir3::new_or(vec3(-0.5, 0.9, 0.6), Dir3::Y);
    let picture = film.render(|place, _| {
        let ray = camera.ray_through(place);
        let Some((_, hit)) = grid.closest(&ray, Interval::AHEAD) else {
            return outdoors::sky(ray.direction);
        };
        let at = stadium.mesh.surface(&ray, &hit);
        let part = stadium.part(hit.id);
        let colour = match part {
            Part::Teapot => Rgb::new(0.7, 0.2, 0.1),
            Part::Ground => Rgb::new(0.15, 0.4, 0.12),
            Part::Steps => Rgb::gray(0.5),
            Part::Seats => Rgb::new(0.1, 0.25, 0.6),
            Part::Roof => Rgb::gray(0.8),
        };
        let n = if part == Part::Teapot {
            at.shading_normal
        } else {
            at.normal
        };
        let side = -at.normal.dot(*ray.direction).signum();
        let c = (side * n.dot(*sun)).max(0.0);
        colour * (0.4 + 0.8 * c)
    });
    println!("{:?}", start.elapsed());
    stage.picture("picture", "p", &picture)?;
    let h = heat::heat(&showroom::small(&film), |p| camera.ray_through(p), &grid);
    stage.figure("heat", "h", &h.figure("cells visited")?)?;
    println!("{:?}", start.elapsed());
    Ok(())
}

fn main() -> ExitCode {
    chapter::run("ch08_grid", draw)
}
