//! The film loop for a camera with a lens: every sample chooses a place in its pixel and a point of the lens.

use crate::camera::Camera;
use crate::image::Image;
use crate::math::{pcg::Pcg, ray::Ray};
use crate::render::film::{Film, place_in_pixel};
use crate::render::followed::Followed;
use glam::vec2;
use rand::seq::SliceRandom;

// ANCHOR: through_lens
/// The picture whose pixels are the mean of what rays see from all over the lens.
///
/// A pixel's samples fill the pixel evenly, and they fill the lens evenly. Which place goes with which point of the lens is
/// left to chance: otherwise the left of the pixel would be seen from the left of the lens (Cook, Porter and Carpenter,
/// "Distributed ray tracing", 1984).
pub fn through_lens<S: Into<Followed>>(
    film: &Film,
    camera: &impl Camera,
    radiance: impl Fn(&Ray, &mut Pcg) -> S + Sync,
) -> Image {
    let size = vec2(film.width as f32, film.height as f32);
    film.render_pixels(|x, y, rng| {
        let places = place_in_pixel(film.samples, rng);
        // A single sample must not always go through the middle of the lens: the second number is for that.
        let points = place_in_pixel(film.samples.max(2), rng);
        let mut order: Vec<_> = (0..film.samples).collect();
        order.shuffle(rng);
        let samples = order.into_iter().enumerate().map(|(i, j)| {
            let place = vec2(x as f32, y as f32) + places(i);
            radiance(&camera.ray(place / size, points(j)), rng).into()
        });
        samples.sum::<Followed>().mean_of(film.samples)
    })
}
// ANCHOR_END: through_lens
