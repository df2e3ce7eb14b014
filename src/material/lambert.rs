//! The ideally matte surface.
//!
//! ```
//! use raybook::prelude::*;
//! use std::f32::consts::PI;
//!
//! let at = Surface::flat(Vec3::ZERO, 0.0, Dir3::Y);
//! let paper = Lambert { albedo: Rgb::gray(0.8) };
//! // f = ρ/π: the integral of f cos θ over the hemisphere is f·π = ρ, the reflected share.
//! assert!((paper.eval(&at, Dir3::Y, Dir3::Y).g * PI - 0.8).abs() < 1e-6);
//! ```

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
