//! Backdrops from a picture: the radiance for rays that meet nothing.

use crate::image::{mip::MipMap, rgb::Rgb};
use crate::light::environment::latlong;
use crate::math::ray::Ray;
use glam::vec2;

/// A latitude–longitude map around the scene, interpolated between its texels, for
/// [`Scene::surrounded_by`](crate::scene::world::Scene::surrounded_by).
///
/// Camera rays, mirrors and paths see it, but it is not sampled. For a map with small bright places, such as the sun, use the
/// light [`Environment`](crate::light::environment::Environment), which samples them.
pub fn panorama(map: MipMap) -> impl Fn(&Ray) -> Rgb + Send + Sync {
    move |ray| {
        let place = latlong::place(ray.direction);
        map.bilinear(0, vec2(place.x, 1.0 - place.y))
    }
}
