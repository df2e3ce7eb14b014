//! # Refraction
//!
//! Glass shows what is in front of it and what is behind it. Snell's law says where the second ray goes, Fresnel's equations
//! how much light takes which way; and every surface knows the media on both of its sides.
//!
//! New: material/refract.rs material/fresnel.rs material/glass.rs scene/glassware.rs

use glam::{Vec3, vec3};
use raybook::camera::pinhole::Pinhole;
use raybook::lab::chapter;
use raybook::lab::stage::{Drawn, Stage};
use raybook::render::local::{ALWAYS, Local};
use raybook::render::whitted::Whitted;
use raybook::scene::glassware;
use std::process::ExitCode;

/// Direct light without shadows, and rays through up to twelve surfaces.
const WHITTED: Whitted = Whitted {
    local: Local {
        samples: 1,
        arrives: ALWAYS,
    },
    depth: glassware::DEPTH,
};

/// Draws the chapter's pictures.
pub(crate) fn draw(stage: &Stage) -> Drawn {
    let film = stage.film(16.0 / 9.0);
    let (from, to) = (vec3(0.4, 3.0, 7.6), vec3(0.1, 0.75, 0.0));
    let camera = Pinhole::look_at(from, to, Vec3::Y, 0.041, film.aspect())?;
    let scene = glassware::still_life();
    let picture =
        film.render(|place, rng| WHITTED.radiance(&scene, &camera.ray_through(place), rng));
    let caption = "A ball of glass, one with a large bubble of air, one in a tank of water, and three of coloured glass.";
    stage.picture("picture", caption, &picture)
}

fn main() -> ExitCode {
    chapter::run("ch14_refraction", draw)
}
