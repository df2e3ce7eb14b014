//! Backdrops: what a ray that meets nothing sees, from a picture.

use crate::image::{mip::MipMap, rgb::Rgb};
use crate::light::environment::latlong;
use crate::math::ray::Ray;
use glam::vec2;

/// A latitude–longitude map around the scene, smooth between its texels, for [`Scene::surrounded_by`](crate::scene::world::Scene::surrounded_by).
///
/// It is seen, in mirrors and by paths too. Where it has a sun in it, [`Environment`](crate::light::environment::Environment) is better:
/// a light, whose bright places are looked for.
pub fn panorama(map: MipMap) -> impl Fn(&Ray) -> Rgb + Send + Sync {
    move |ray| {
        let place = latlong::place(ray.direction);
        map.bilinear(0, vec2(place.x, 1.0 - place.y))
    }
}
