//! Small bright lights through a lens, which rays from the camera cannot find.
//!
//! ```
//! use raybook::prelude::*;
//! use raybook::render::glints::add_glints;
//!
//! let body = Pinhole::look_at(Vec3::ZERO, -Vec3::Z, Vec3::Y, 0.050, 1.0)?;
//! let camera = ThinLens::new(&body, 2.0, 3.0, Aperture::Round)?;
//! let film = Film::new(9, 9, 4);
//! let mut picture = Image::from_fn(9, 9, |_, _| Rgb::BLACK);
//! // A lamp in focus, in the middle of the view, lights one pixel only.
//! let lamp = PointLight { position: vec3(0.0, 0.0, -3.0), intensity: Rgb::WHITE };
//! add_glints(&mut picture, &film, &camera, &[lamp], |_, _| true);
//! assert_eq!(picture.pixels().iter().filter(|pixel| pixel.g > 0.0).count(), 1);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::camera::thin_lens::ThinLens;
use crate::image::Image;
use crate::light::point::PointLight;
use crate::math::{pcg, ray::Ray};
use crate::render::film::{Done, Film, place_in_pixel};
use glam::{Vec2, vec2};
use std::f32::consts::FRAC_PI_4;

/// Number of rays for each pixel that a light's disc covers: enough that the disc shows no grain.
const PER_PIXEL: f32 = 80.0;

/// Minimum and maximum number of rays for a light. A disc that would need more is so large, and therefore so dark, that its grain
/// is not seen.
const RAYS: [f32; 2] = [256.0, 1e6];

// ANCHOR: glints
/// Adds to the picture the light of point lights that comes straight through the lens.
///
/// A ray from the camera meets a point with probability 0. So the rays start at the light: each of N rays goes through a point of
/// the lens to a place on the film, and adds the radiance I·m/(N·A) to the pixel that it meets. I is the light's intensity, m the
/// magnification ([`magnified`](crate::camera::thin_lens::Arrival::magnified)), and A the area of a pixel on the film, in m².
/// `open` returns whether the way along a ray from the lens, up to a distance in metres, is free.
pub fn add_glints(
    picture: &mut Image,
    film: &Film,
    camera: &ThinLens,
    lights: &[PointLight],
    open: impl Fn(&Ray, f32) -> bool,
) {
    let (width, height) = (picture.width() as f32, picture.height() as f32);
    let pixel = camera.view.plane.x * camera.view.plane.y / (width * height);
    for (light, i) in lights.iter().zip(0..) {
        if (film.progress)(Done::default()).is_break() {
            return;
        }
        let Some(middle) = camera.arrival(light.position, Vec2::ZERO) else {
            continue; // beside the lens or behind it: no light comes in
        };
        let depth = (light.position - camera.view.focal_point).dot(*camera.view.forward);
        let diameter = camera.lens.circle_of_confusion(depth);
        let disc = diameter / camera.view.plane;
        // A disc that is not on the film needs no rays; it counts as a pixel wider than it is, because of rounding.
        let farthest = 0.5 + 0.5 * disc + vec2(width, height).recip();
        if (middle.film - 0.5).abs().cmpgt(farthest).any() {
            continue;
        }
        let covered = FRAC_PI_4 * diameter.powi(2) / pixel;
        let rays = (PER_PIXEL * covered).clamp(RAYS[0], RAYS[1]) as usize;
        let points = place_in_pixel(rays, &mut pcg::stream(pcg::mix(film.seed), i));
        for point in (0..rays).map(points) {
            let Some(arrival) = camera.arrival(light.position, camera.aperture.point(point)) else {
                continue;
            };
            let (x, y) = (arrival.film.x * width, arrival.film.y * height);
            let inside = x >= 0.0 && y >= 0.0 && x < width && y < height;
            if inside && open(&arrival.ray, arrival.distance) {
                let (x, y) = (x as usize, y as usize);
                let share = arrival.magnified / (pixel * rays as f32);
                picture.set(x, y, picture.at(x, y) + light.intensity * share);
            }
        }
    }
}
// ANCHOR_END: glints
