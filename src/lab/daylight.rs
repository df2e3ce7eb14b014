//! Sun and sky, before there are lights: enough to see shapes and their shadows.

use crate::image::rgb::Rgb;
use crate::math::{dir3::Dir3, ray::Ray};
use crate::shape::Surface;
use glam::vec3;

/// A surface's colour in the light of the sun, where nothing is in its way, and of the sky.
///
/// `normal` is the one to shade with; it is turned to the side that is seen. `any` says whether a ray hits anything.
pub fn daylight(
    colour: Rgb,
    at: &Surface,
    normal: Dir3,
    seen: &Ray,
    any: impl FnOnce(&Ray) -> bool,
) -> Rgb {
    let sun = Dir3::new_or(vec3(-0.62, 0.75, 0.42), Dir3::Y);
    let normal = if at.normal.dot(*seen.direction) > 0.0 {
        -normal
    } else {
        normal
    };
    let toward = normal.dot(*sun);
    let sunlight = if toward > 0.0 && !any(&at.leave(sun)) {
        toward
    } else {
        0.0
    };
    let sky = 0.5 + 0.5 * normal.y;
    let tint = |light: Rgb| Rgb::new(colour.r * light.r, colour.g * light.g, colour.b * light.b);
    tint(Rgb::new(1.0, 0.93, 0.80) * (0.95 * sunlight) + Rgb::new(0.62, 0.74, 0.95) * (0.38 * sky))
}
