//! Shadows: whether light from a lamp arrives.

use crate::light::LightSample;
use crate::math::{interval::Interval, ray::Ray};
use crate::scene::world::Scene;
use crate::shape::{ROUNDING, Surface};

// ANCHOR: shadow_ray
/// The ray from a surface towards a light, and the stretch of it on which something is in the way.
///
/// It starts off the surface (see [`Surface::leave`]), and ends before the light: what is behind the light, or carries
/// it, throws no shadow. It ends the sooner by what rounding may be at both ends: the start may be √3·e nearer, with
/// e = `error`, and whatever carries the light is off by a share of the way.
pub fn shadow_ray(at: &Surface, light: &LightSample) -> (Ray, Interval) {
    let ray = at.leave(light.toward);
    let margin = 2.0 * at.error + ROUNDING * light.distance;
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
pub fn lit<M: ?Sized + Send + Sync>(scene: &Scene<M>, at: &Surface, light: &LightSample) -> bool {
    let (ray, way) = shadow_ray(at, light);
    !scene.blocks(&ray, way)
}
// ANCHOR_END: lit
