//! Soft shadows: how much of a light is seen from a surface.

use crate::light::Light;
use crate::math::pcg::Pcg;
use crate::render::shadow;
use crate::scene::world::Scene;
use crate::shape::Surface;
use glam::vec2;
use rand::RngExt;

// ANCHOR: visible_fraction
/// An estimate of how much of a light is seen from a surface: the share of n random samples that arrive.
///
/// 0 in the umbra, 1 in full light, and in between in the penumbra. Of n samples, each arrives with the probability f that
/// is asked for, so the estimate is off by √(f(1 − f)/n), in the root of the mean square.
/// A light that is chosen by area is measured by its area.
pub fn visible_fraction(
    scene: &Scene,
    at: &Surface,
    light: &dyn Light,
    samples: u32,
    rng: &mut Pcg,
) -> f32 {
    let mut seen = 0_u32;
    for _ in 0..samples {
        let sample = light.sample(at.position, vec2(rng.random(), rng.random()));
        seen += u32::from(sample.is_some_and(|sample| shadow::lit(scene, at, &sample)));
    }
    seen as f32 / samples.max(1) as f32
}
// ANCHOR_END: visible_fraction
