//! Shadows: whether light from a light source arrives at a surface.
//!
//! ```
//! use raybook::prelude::*;
//! use raybook::render::shadow::shadow_ray;
//!
//! // The interval of a shadow ray ends before the lamp: what is behind the lamp throws no shadow.
//! let lamp = PointLight { position: vec3(0.0, 3.0, 0.0), intensity: Rgb::WHITE };
//! let at = Surface::flat(Vec3::ZERO, 1e-6, Dir3::Y);
//! let sample = lamp.sample(at.position, Vec2::ZERO).expect("shines everywhere");
//! let (ray, way) = shadow_ray(&at, &sample);
//! assert_eq!(ray.direction, Dir3::Y);
//! assert!(way.contains(2.99) && !way.contains(3.0));
//! ```

use crate::light::LightSample;
use crate::math::{interval::Interval, ray::Ray};
use crate::scene::world::Scene;
use crate::shape::Surface;

/// The last part of the way to a light that is not tested, as a share of the distance.
///
/// A lamp in a ceiling must not be hidden by the ceiling. A ray that starts a step off the surface meets the ceiling earlier, by
/// the step over the cosine there. The step is about 2e-6 of the scene's size. So 1e-4 is enough down to a cosine of 0.02; it is
/// half a millimetre at a distance of 5 m.
const BEFORE_LIGHT: f32 = 1e-4;

// ANCHOR: shadow_ray
/// The ray from a surface towards a light, and the interval in which a hit blocks the light.
///
/// The ray starts off the surface (see [`Surface::leave_smooth`]). The interval ends before the light, so that a shape behind the
/// light, or the shape that carries it, throws no shadow. With e = `error`, the start may be nearer to the light than the point,
/// by up to √3·e (here 2e) or the length of `clear`, plus that of `lift`.
pub fn shadow_ray(at: &Surface, light: &LightSample) -> (Ray, Interval) {
    let ray = at.leave_smooth(light.toward);
    let start = 2.0 * at.error + at.clear.length() + at.lift.length();
    let margin = start + BEFORE_LIGHT * light.distance;
    // Everything ahead is before a light at ∞; ∞ − ∞ would be NaN.
    let end = if light.distance.is_finite() {
        (light.distance - margin).max(0.0)
    } else {
        f32::INFINITY
    };
    (ray, Interval::new(0.0, end))
}
// ANCHOR_END: shadow_ray

// ANCHOR: lit
/// Whether light arrives at a surface, because nothing is in its way. Any hit blocks the light, so the search ends at the first.
pub fn lit(scene: &Scene, at: &Surface, light: &LightSample) -> bool {
    let (ray, way) = shadow_ray(at, light);
    !scene.blocks(&ray, way)
}
// ANCHOR_END: lit
