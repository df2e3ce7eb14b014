//! The noise of few samples of a lens: a detail of the tea table with 4 and with 128 random points, and with 4 that are spread.

use raybook::camera::{Camera, aperture::Aperture, pinhole::Pinhole, thin_lens::ThinLens};
use raybook::image::Image;
use crate::kit::sheet::sheet;
use raybook::math::{pcg::Pcg, ray::Ray};
use raybook::render::{film::Film, followed::Followed, through_lens::through_lens};
use raybook::scene::tea_table::{DETAIL, EYE, FOCAL_LENGTH};
use glam::{Vec3, vec2};
use rand::RngExt;
use std::error::Error;

/// How much of the film is shown, in width and height.
const PART: f32 = 0.5;

/// Focused at 1 m; `see` tells what a ray sees.
///
/// # Errors
/// If the tiles' names cannot be drawn.
pub fn draw(
    tile: &Film,
    see: impl Fn(&Ray, &mut Pcg) -> Followed + Sync,
) -> Result<Image, Box<dyn Error>> {
    let mut body = Pinhole::look_at(EYE, DETAIL, Vec3::Y, FOCAL_LENGTH, tile.aspect())?;
    body.plane *= PART;
    let camera = ThinLens::new(&body, 1.4, 1.0, Aperture::Round)?;
    let film = |samples| Film { samples, ..*tile };
    let by_chance = |samples| {
        film(samples).render(|place, rng| {
            let ray = camera.ray(place, vec2(rng.random(), rng.random()));
            see(&ray, rng)
        })
    };
    let tiles = [
        ("4 samples", by_chance(4)),
        ("128 samples", by_chance(128)),
        ("4, spread evenly", through_lens(&film(4), &camera, &see)),
    ];
    sheet(3, &tiles)
}
