//! # Capstone
//!
//! A whole ray tracer in one function: the radiance of a ray through a scene that is described on a line, in pictures of four
//! scenes of rising difficulty.
//!
//! New: scene/description.rs scene/four_scenes.rs render/trace.rs

use glam::Vec3;
use raybook::camera::pinhole::{LookAtError, Pinhole};
use raybook::image::Image;
use raybook::lab::stage::{Drawn, Stage};
use raybook::lab::{chapter, sheet::sheet};
use raybook::render::{film::Film, trace::trace};
use raybook::scene::four_scenes::{ASPECT, FOUR, Staged};
use std::process::ExitCode;

/// Draws the chapter's pictures.
pub(crate) fn draw(stage: &Stage) -> Drawn {
    let mut tiles = Vec::new();
    for staged in &FOUR {
        let film = stage.tile(2, ASPECT);
        let samples = film.samples.min(9);
        tiles.push((staged.name, photograph(&Film { samples, ..film }, staged)?));
    }
    stage.picture("picture", "Four scenes.", &sheet(2, &tiles)?)
}

/// The scene as its camera sees it.
fn photograph(film: &Film, staged: &Staged) -> Result<Image, LookAtError> {
    let [from, to] = staged.view;
    let camera = Pinhole::look_at(from, to, Vec3::Y, staged.focal_length, film.aspect())?;
    let scene = (staged.scene)();
    Ok(film.render(|place, _| trace(&scene, &camera.ray_through(place), staged.depth)))
}

fn main() -> ExitCode {
    chapter::run("ch25_capstone", draw)
}
