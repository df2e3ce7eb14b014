//! The film loop for a camera with a lens: every sample chooses a place in its pixel and a point of the lens.
//!
//! ```
//! use raybook::prelude::*;
//! use raybook::render::through_lens::through_lens;
//!
//! let body = Pinhole::look_at(Vec3::ZERO, -Vec3::Z, Vec3::Y, 0.050, 1.0)?;
//! let camera = ThinLens::new(&body, 2.0, 3.0, Aperture::Round)?;
//! // The mean of x over all points where the rays start is 0: the middle of the lens.
//! let picture = through_lens(&Film::new(1, 1, 64), &camera, |ray, _| Rgb::gray(ray.origin.x));
//! assert!(picture.at(0, 0).g.abs() < 0.001); // the lens is 0.025 m wide
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::camera::Camera;
use crate::image::Image;
use crate::math::ray::Ray;
use crate::render::{film::Film, followed::Followed};
use crate::sample::even::Even;

// ANCHOR: through_lens
/// The picture whose pixels are the mean radiance of rays from all points of the lens.
///
/// A pixel's samples fill the pixel evenly, and they fill the lens evenly. Places in the pixel and points of the lens are paired
/// at random: otherwise the left of the pixel would be seen from the left of the lens only (Cook, Porter and Carpenter,
/// "Distributed ray tracing", 1984).
pub fn through_lens<S: Into<Followed>>(
    film: &Film,
    camera: &impl Camera,
    radiance: impl Fn(&Ray, &mut Even) -> S + Sync,
) -> Image {
    film.evenly(|place, numbers| {
        let ray = camera.ray(place, numbers.pair());
        radiance(&ray, numbers)
    })
}
// ANCHOR_END: through_lens
