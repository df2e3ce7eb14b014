//! Blinn's variant of Phong's model as a physical BRDF: reciprocal and energy-conserving.
//!
//! ```
//! use raybook::material::normalised_blinn_phong::NormalisedBlinnPhong;
//! use raybook::prelude::*;
//!
//! let [diffuse, specular] = [Rgb::gray(0.5), Rgb::gray(0.3)];
//! let glossy = NormalisedBlinnPhong { diffuse, specular, exponent: 100.0 };
//! let sharper = NormalisedBlinnPhong { exponent: 1000.0, ..glossy };
//! let up = |material: NormalisedBlinnPhong| material.value(Dir3::Y, Dir3::Y, Dir3::Y).g;
//! assert!(up(sharper) > 5.0 * up(glossy), "a smaller highlight is brighter");
//! ```

use crate::image::rgb::Rgb;
use crate::material::Material;
use crate::material::matte_and_glossy::MatteAndGlossy;
use crate::material::mirror::reflect;
use crate::math::dir3::Dir3;
use crate::sample::hemisphere::{lobe, lobe_pdf};
use crate::shape::Surface;
use glam::Vec2;
use std::f32::consts::{FRAC_1_PI, PI};

/// A matte part and a glossy one, whose highlight is a power of N·H (Blinn, "Models of light reflection for computer synthesized
/// pictures", 1977). It reflects no more light than arrives if ρ_d + ρ_s ≤ 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NormalisedBlinnPhong {
    /// ρ_d: the share of the light that is scattered to all sides.
    pub diffuse: Rgb,
    /// ρ_s: the share that leaves in the highlight, for light from straight above; for oblique light it is less.
    pub specular: Rgb,
    /// n: the exponent; the larger n, the smaller and sharper the highlight. About 4 times the exponent of Phong's model makes a
    /// highlight of the same size.
    pub exponent: f32,
}

impl NormalisedBlinnPhong {
    /// f = ρ_d/π + ρ_s (n + 2)(n + 4)/(8π (2^(−n/2) + n)) (N·H)ⁿ, in 1/sr; H = (L + V)/|L + V| is the halfway vector.
    ///
    /// For light from straight above, H is at half the angle of V, and ∫ cosⁿ(θ/2) cos θ dω over the hemisphere is
    /// 8π (2^(−n/2) + n)/((n + 2)(n + 4)), so that the share ρ_s leaves in the highlight (Giesen, "Derivation of Phong
    /// and Blinn-Phong BRDF normalization factors", 2009). f does not contain the cosine of the light's direction, which belongs to the irradiance. f is 0
    /// if L or V is not above the surface.
    pub fn value(&self, normal: Dir3, view: Dir3, toward: Dir3) -> Rgb {
        if normal.dot(*toward) <= 0.0 || normal.dot(*view) <= 0.0 {
            return Rgb::BLACK;
        }
        let n = self.exponent;
        let factor = (n + 2.0) * (n + 4.0) / (8.0 * PI * ((-0.5 * n).exp2() + n));
        let half = Dir3::new_or(*toward + *view, normal);
        self.diffuse * FRAC_1_PI + self.specular * (factor * normal.dot(*half).powf(n))
    }
}

impl Material for NormalisedBlinnPhong {
    fn eval(&self, at: &Surface, view: Dir3, toward: Dir3) -> Rgb {
        self.value(at.facing(view), view, toward)
    }

    /// For the highlight, H is chosen with a density proportional to (N·H)ⁿ, and the viewer is mirrored at H.
    fn sample(&self, at: &Surface, view: Dir3, u: Vec2) -> Option<Dir3> {
        let normal = at.facing(view);
        MatteAndGlossy::of(self.diffuse, self.specular).sample(normal, u, |u| {
            reflect(-view, lobe(normal, self.exponent, u))
        })
    }

    /// The density of the highlight is the density of H over 4 (V·H), the factor between solid angles of H and of the mirror
    /// direction (Torrance and Sparrow 1967).
    fn pdf(&self, at: &Surface, view: Dir3, toward: Dir3) -> f32 {
        let normal = at.facing(view);
        MatteAndGlossy::of(self.diffuse, self.specular).pdf(normal, toward, || {
            Dir3::new(*view + *toward).map_or(0.0, |half| {
                lobe_pdf(normal.dot(*half), self.exponent) / (4.0 * view.dot(*half))
            })
        })
    }
}
