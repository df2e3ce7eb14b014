//! The noise of few samples of a lens: a detail of the tea table with 4 and with 64 random points, and with 4 points that are
//! spread evenly.

use super::tea_table::{DETAIL, EYE, FOCAL_LENGTH};
use crate::kit::sheet::sheet;
use glam::{Vec3, vec2};
use rand::RngExt;
use raybook::camera::Camera;
use raybook::camera::aperture::Aperture;
use raybook::camera::pinhole::Pinhole;
use raybook::camera::thin_lens::ThinLens;
use raybook::image::Image;
use raybook::render::film::Film;
use raybook::render::sampler::Sampler;
use raybook::render::whitted::Whitted;
use raybook::scene::world::Scene;
use std::error::Error;

/// How much of the film is shown, in width and height.
const PART: f32 = 0.5;

/// The three pictures, with a lens that is focused at 1 m.
///
/// # Errors
/// If the tiles' names cannot be drawn.
pub(super) fn draw(tile: &Film, scene: &Scene, whitted: &Whitted) -> Result<Image, Box<dyn Error>> {
    let mut body = Pinhole::look_at(EYE, DETAIL, Vec3::Y, FOCAL_LENGTH, tile.aspect())?;
    body.plane *= PART;
    let camera = ThinLens::new(&body, 1.4, 1.0, Aperture::Round)?;
    let film = |samples| Film { samples, ..*tile };
    let by_chance = |samples| {
        film(samples).sample(|place, rng| {
            let ray = camera.ray(place, vec2(rng.random(), rng.random()));
            whitted.follow(scene, &ray, rng)
        })
    };
    let spread = film(4).render(&camera, &Sampler::Even, whitted, scene);
    let tiles = [
        ("4 samples", by_chance(4)),
        ("64 samples", by_chance(64)),
        ("4, spread evenly", spread),
    ];
    sheet(3, &tiles)
}
