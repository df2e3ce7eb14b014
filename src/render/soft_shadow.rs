//! Soft shadows: the fraction of a light that is seen from a surface.
//!
//! ```
//! use raybook::math::pcg;
//! use raybook::prelude::*;
//! use raybook::render::soft_shadow::visible_fraction;
//!
//! // A roof over x < 0 hides half of the lamp.
//! let lamp = RectLight::new(vec3(-1.0, 4.0, -1.0), vec3(2.0, 0.0, 0.0), vec3(0.0, 0.0, 2.0), Rgb::WHITE);
//! let roof = Thing::new(Cuboid::between(vec3(-9.0, 2.0, -9.0), vec3(0.0, 2.1, 9.0)), ());
//! let scene = Scene::new(vec![roof], vec![]);
//! let at = Surface::flat(Vec3::ZERO, 0.0, Dir3::Y);
//! let seen = visible_fraction(&scene, &at, &lamp, 1000, &mut pcg::stream(1, 0));
//! assert!((seen - 0.5).abs() < 0.06); // the error is √(½·½/1000) = 0.016
//! ```

use crate::light::Light;
use crate::math::pcg::Pcg;
use crate::render::shadow;
use crate::scene::world::Scene;
use crate::shape::Surface;
use glam::vec2;
use rand::RngExt;

// ANCHOR: visible_fraction
/// An estimate of the fraction f of a light that is seen from a surface: the share of n = `samples` random samples that arrive.
///
/// 0 in the umbra, 1 in full light, and in between in the penumbra. Each sample arrives with the probability f, so the root of
/// the mean square (RMS) error is √(f(1 − f)/n). f is a fraction of the area if the light chooses its points by area, and of the
/// solid angle if it chooses them by solid angle. 0 if `samples` is 0.
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
