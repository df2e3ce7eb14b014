//! The sun, for pictures of large meshes: light from one direction, and shadows.

use crate::image::rgb::Rgb;
use crate::math::{dir3::Dir3, ray::Ray};
use crate::shape::Surface;
use glam::vec3;

/// Where the sun is.
pub fn sun() -> Dir3 {
    Dir3::new_or(vec3(-0.55, 0.6, 0.5), Dir3::Y)
}

/// What a ray sees of a surface of this colour: the light of the sky, and that of the sun where no ray towards it is blocked.
///
/// The light falls off with the cosine of its angle to the shading normal, on the side from which the surface is seen.
pub fn lit(colour: Rgb, at: &Surface, ray: &Ray, is_blocked: impl FnOnce(&Ray) -> bool) -> Rgb {
    let side = -at.normal.dot(*ray.direction).signum();
    let cosine = side * at.shading_normal.dot(*sun());
    // In the plane of the triangle too, for the shading normal is only a pretence.
    let in_sun = cosine > 0.0 && side * at.normal.dot(*sun()) > 0.0;
    let sunlight = if in_sun && !is_blocked(&at.leave(sun())) {
        cosine
    } else {
        0.0
    };
    let sky = 0.5 + 0.5 * side * at.shading_normal.y;
    colour * (Rgb::new(0.26, 0.31, 0.40) * sky + Rgb::new(1.12, 1.02, 0.86) * sunlight)
}
