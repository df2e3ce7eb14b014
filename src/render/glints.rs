//! Small bright lights through a lens: they are too small for rays from the camera to find.

use crate::camera::thin_lens::ThinLens;
use crate::image::Image;
use crate::light::point::PointLight;
use crate::math::{pcg, ray::Ray};
use crate::render::film::{Film, place_in_pixel};
use std::f32::consts::FRAC_PI_4;

/// Rays for each pixel that a light's disc covers: with this number their even spread shows no grain.
const PER_PIXEL: f32 = 40.0;

/// The fewest rays for a light, and the most.
const RAYS: [f32; 2] = [256.0, 4e6];

// ANCHOR: glints
/// Adds what point lights send through the lens.
///
/// A ray from the camera meets a point with probability 0. So the rays start at the light: each goes through a point of the
/// lens to a place on the film, and brings a share of I · (area on the film)/(area around the light) to the pixel it meets,
/// which is the mean radiance there. `open` tells whether nothing is on a ray from the lens up to a distance.
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
        let depth = (light.position - camera.view.focal_point).dot(*camera.view.forward);
        if depth <= 0.0 {
            continue; // beside the lens or behind it: none of its light comes in
        }
        let covered = FRAC_PI_4 * camera.lens.circle_of_confusion(depth).powi(2) / pixel;
        let rays = (PER_PIXEL * covered).clamp(RAYS[0], RAYS[1]) as usize;
        let points = place_in_pixel(rays, &mut pcg::stream(film.seed, i));
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
