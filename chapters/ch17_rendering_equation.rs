//! # Rendering equation
//!
//! Light that a surface sends to the eye has come from all sides, also from other surfaces. One integral over the
//! hemisphere says how much of it there is, and path tracing estimates it: by the mean over random paths, chosen with care.
//!
//! New: sample/mod.rs sample/hemisphere.rs material/brdf.rs material/lambert.rs material/modified_phong.rs
//! New: render/mis.rs render/path.rs render/reflection.rs scene/cornell.rs scene/plates.rs

use glam::Vec3;
use raybook::camera::pinhole::{LookAtError, PLANE_HEIGHT, Pinhole};
use raybook::image::{Image, rgb::Rgb};
use raybook::lab::chapter;
use raybook::lab::stage::{Drawn, Stage};
use raybook::material::brdf::Brdf;
use raybook::render::film::Film;
use raybook::render::{mis::Strategy, path::Path};
use raybook::scene::{cornell, world::Scene};
use std::process::ExitCode;

/// Draws the chapter's pictures.
pub(crate) fn draw(stage: &Stage) -> Drawn {
    let film = stage.film_of(400, 100, 1.0);
    let picture = cornell_box(&film, u32::MAX)?;
    stage.picture("picture", "The Cornell box.", &picture)
}

/// The Cornell box by paths over at most so many surfaces.
fn cornell_box(film: &Film, depth: u32) -> Result<Image, LookAtError> {
    let scene = cornell::cornell_box();
    let path = Path {
        depth,
        sure: 3,
        strategy: Strategy::Both,
    };
    let focal_length = cornell::ZOOM * PLANE_HEIGHT;
    let camera = Pinhole::look_at(
        cornell::EYE,
        cornell::EYE + Vec3::Z,
        Vec3::Y,
        focal_length,
        film.aspect(),
    )?;
    Ok(film.render(|place, rng| path.radiance(&scene, &camera.ray_through(place), rng)))
}

fn main() -> ExitCode {
    chapter::run("ch17_rendering_equation", draw)
}
