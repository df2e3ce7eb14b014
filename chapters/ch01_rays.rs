//! # Rays
//!
//! A pin-hole camera turns each pixel into a ray, r(t) = o + t·d: from the focal point through the pixel's centre.
//!
//! New: math/mod.rs math/dir3.rs math/ray.rs math/pcg.rs image/mod.rs image/rgb.rs
//! New: camera/mod.rs camera/pinhole.rs render/mod.rs render/film.rs

use glam::{Vec2, Vec3, vec3};
use raybook::camera::{Camera, pinhole::Pinhole};
use raybook::image::rgb::Rgb;
use raybook::lab::chapter;
use raybook::lab::stage::{Drawn, Stage};
use std::process::ExitCode;

/// Draws the chapter's pictures.
pub(crate) fn draw(stage: &Stage) -> Drawn {
    let film = stage.film(16.0 / 9.0);
    let camera = Pinhole::look_at(
        Vec3::ZERO,
        vec3(0.0, 0.3, -1.0),
        Vec3::Y,
        0.018,
        film.aspect(),
    )?;
    let picture = film.render(|place, _| {
        let d = camera.ray(place, Vec2::ZERO).direction;
        Rgb::new(d.x, d.y, d.z).map(|v| 0.5 + 0.5 * v)
    });
    stage.picture(
        "picture",
        "The direction of every pixel's ray as a colour.",
        &picture,
    )
}

fn main() -> ExitCode {
    chapter::run("ch01_rays", draw)
}
