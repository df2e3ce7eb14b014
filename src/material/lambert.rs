//! The ideally matte surface.

use crate::image::rgb::Rgb;
use crate::material::Material;
use crate::math::dir3::Dir3;
use crate::shape::Surface;
use std::f32::consts::FRAC_1_PI;

/// A surface that looks equally bright from all directions (Lambert, *Photometria*, 1760).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lambert {
    /// ρ: the albedo, the share of the light that is reflected, from 0 to 1.
    pub albedo: Rgb,
}

impl Material for Lambert {
    // ANCHOR: lambert
    /// f = ρ/π, in 1/sr: ∫ cos θ dω over the hemisphere is π, so that the share ρ of the light that arrives leaves again.
    fn eval(&self, at: &Surface, view: Dir3, toward: Dir3) -> Rgb {
        if at.facing(view).dot(*toward) > 0.0 {
            self.albedo * FRAC_1_PI
        } else {
            Rgb::BLACK
        }
    }
    // ANCHOR_END: lambert
}
