//! Phong's model as a physical BRDF: reciprocal and energy-conserving.
//!
//! ```
//! use raybook::material::modified_phong::ModifiedPhong;
//! use raybook::prelude::*;
//!
//! let gloss = ModifiedPhong { diffuse: Rgb::gray(0.3), specular: Rgb::gray(0.5), exponent: 30.0 };
//! let [a, b] = [vec3(0.6, 0.8, 0.0), vec3(-0.28, 0.96, 0.0)].map(|v| Dir3::new_or(v, Dir3::Y));
//! assert!((gloss.value(Dir3::Y, a, b).g - gloss.value(Dir3::Y, b, a).g).abs() < 1e-5); // reciprocal
//! ```

use crate::image::rgb::Rgb;
use crate::material::{Material, matte_and_glossy::MatteAndGlossy};
use crate::math::dir3::Dir3;
use crate::sample::hemisphere::{lobe, lobe_pdf};
use crate::shape::Surface;
use glam::Vec2;
use std::f32::consts::{FRAC_1_PI, TAU};

/// A matte part and a glossy one (Lafortune and Willems, "Using the modified Phong reflectance model for physically based
/// rendering", 1994). It reflects no more light than arrives if ρ_d + ρ_s ≤ 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ModifiedPhong {
    /// ρ_d: the share of the light that is scattered to all sides.
    pub diffuse: Rgb,
    /// ρ_s: the share that leaves in the highlight, for light from straight above; for oblique light it is less.
    pub specular: Rgb,
    /// n: the exponent; the larger n, the smaller and sharper the highlight.
    pub exponent: f32,
}

impl ModifiedPhong {
    // ANCHOR: brdf_phong
    /// f = ρ_d/π + ρ_s (n + 2)/2π cosⁿα, in 1/sr; α is the angle between the viewer and the mirror direction R = 2 (L·N) N − L.
    ///
    /// For light from straight above, ∫ cosⁿα cos θ dω = 2π/(n + 2), so that the share ρ_s leaves in the highlight. For oblique
    /// light it is less, because part of the lobe is below the surface. f does not contain the cosine of the light's direction,
    /// which belongs to the irradiance. f is 0 if L or V is not above the surface; there is no highlight if α ≥ 90°.
    pub fn value(&self, normal: Dir3, view: Dir3, toward: Dir3) -> Rgb {
        let cosine = normal.dot(*toward);
        if cosine <= 0.0 || normal.dot(*view) <= 0.0 {
            return Rgb::BLACK;
        }
        let mirrored = 2.0 * cosine * *normal - *toward;
        let matte = self.diffuse * FRAC_1_PI;
        let cos_alpha = mirrored.dot(*view);
        if cos_alpha <= 0.0 {
            return matte;
        }
        matte + self.specular * ((self.exponent + 2.0) / TAU * cos_alpha.powf(self.exponent))
    }
    // ANCHOR_END: brdf_phong
}

/// The mirror direction of the viewer, 2 (V·N) N − V.
fn mirrored(normal: Dir3, view: Dir3) -> Dir3 {
    Dir3::new_or(2.0 * view.dot(*normal) * *normal - *view, normal)
}

impl Material for ModifiedPhong {
    fn eval(&self, at: &Surface, view: Dir3, toward: Dir3) -> Rgb {
        self.value(at.facing(view), view, toward)
    }

    /// For the highlight, a direction around the mirror direction of the viewer with a density proportional to cosⁿα.
    fn sample(&self, at: &Surface, view: Dir3, u: Vec2) -> Option<Dir3> {
        let normal = at.facing(view);
        MatteAndGlossy::of(self.diffuse, self.specular).sample(normal, u, |u| {
            lobe(mirrored(normal, view), self.exponent, u)
        })
    }

    fn pdf(&self, at: &Surface, view: Dir3, toward: Dir3) -> f32 {
        let normal = at.facing(view);
        MatteAndGlossy::of(self.diffuse, self.specular).pdf(normal, toward, || {
            lobe_pdf(mirrored(normal, view).dot(*toward), self.exponent)
        })
    }
}
