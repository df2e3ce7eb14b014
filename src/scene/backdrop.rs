//! Backdrops from a picture: the radiance for rays that meet nothing.
//!
//! ```
//! use raybook::prelude::*;
//! use raybook::scene::backdrop::panorama;
//!
//! let map = MipMap::new(&Image::from_fn(8, 4, |_, y| Rgb::gray(if y < 2 { 1.0 } else { 0.2 })));
//! let sky = panorama(map);
//! let upwards = Dir3::new(vec3(0.0, 1.0, -1.0)).expect("longer than 0");
//! assert_eq!(sky(&Ray::new(Vec3::ZERO, upwards)), Rgb::WHITE);
//! ```

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
