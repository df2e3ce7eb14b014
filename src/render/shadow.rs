//! Shadows: whether light from a lamp arrives.

use crate::light::LightSample;
use crate::math::{interval::Interval, ray::Ray};
use crate::scene::world::Scene;
use crate::shape::Surface;

/// The share of the way to a light that is left out before it.
///
/// A lamp in a ceiling must not be hidden by the ceiling. A ray that starts a step off the surface meets the ceiling
/// sooner by the step over the cosine there. The step is about 2e-6 of the scene's size: 1e-4 is enough down to a cosine
/// of 0.02, and half a millimetre of 5 m.
const BEFORE_LIGHT: f32 = 1e-4;

// ANCHOR: shadow_ray
/// The ray from a surface towards a light, and the stretch of it on which something is in the way.
///
/// It starts off the surface (see [`Surface::leave_smooth`]), and ends before the light: what is behind the light, or carries
/// it, throws no shadow. With e = `error`, the start is up to √3·e nearer to the light than the point, or as far as `clear`.
pub fn shadow_ray(at: &Surface, light: &LightSample) -> (Ray, Interval) {
    let ray = at.leave_smooth(light.toward);
    let start = 2.0 * at.error + at.clear.length() + at.lift.length();
    let margin = start + BEFORE_LIGHT * light.distance;
    // Of a light at ∞ everything ahead is before it; ∞ − ∞ would be NaN.
    let end = if light.distance.is_finite() {
        (light.distance - margin).max(0.0)
    } else {
        f32::INFINITY
    };
    (ray, Interval::new(0.0, end))
}
// ANCHOR_END: shadow_ray

// ANCHOR: lit
/// Whether light arrives at a surface: nothing is in its way. Any hit will do, so the search ends at the first.
pub fn lit(scene: &Scene, at: &Surface, light: &LightSample) -> bool {
    let (ray, way) = shadow_ray(at, light);
    !scene.blocks(&ray, way)
}
// ANCHOR_END: lit
