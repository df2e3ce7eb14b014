//! Phong's model as a BRDF that keeps the laws of nature.

use crate::image::rgb::Rgb;
use crate::material::Material;
use crate::math::dir3::Dir3;
use crate::sample::hemisphere::{cosine_hemisphere, cosine_pdf, lobe, lobe_pdf};
use crate::shape::Surface;
use glam::{Vec2, vec2};
use std::f32::consts::{FRAC_1_PI, TAU};

/// A matte part and a glossy one (Lafortune and Willems, "Using the modified Phong reflectance model for physically based
/// rendering", 1994). It reflects no more light than arrives if ρ_d + ρ_s ≤ 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ModifiedPhong {
    /// ρ_d: the share of the light that leaves to all sides.
    pub diffuse: Rgb,
    /// ρ_s: the share that leaves in the highlight, of light from straight above; of slanting light, part of it is lost.
    pub specular: Rgb,
    /// n: the larger, the smaller and sharper the highlight.
    pub exponent: f32,
}

impl ModifiedPhong {
    // ANCHOR: brdf_phong
    /// f = ρ_d/π + ρ_s (n + 2)/2π cosⁿα, in 1/sr; α is the angle between the viewer and the mirror direction R = 2 (L·N) N − L.
    ///
    /// From straight above, ∫ cosⁿα cos θ dω = 2π/(n + 2), so that a share ρ_s leaves in the highlight; from elsewhere less,
    /// for part of the lobe is below the surface. There is no cosine in f: it belongs to the light that arrives.
    /// 0 if L or V is not above the surface; no highlight if α ≥ 90°.
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

    /// The probability with which a direction is chosen for the highlight: its share of the light.
    fn glossy(&self) -> f32 {
        let [matte, glossy] = [self.diffuse, self.specular].map(Rgb::luminance);
        glossy / (matte + glossy).max(f32::MIN_POSITIVE)
    }
}

/// The direction in which a viewer sees the surface's mirror image.
fn mirrored(normal: Dir3, view: Dir3) -> Dir3 {
    Dir3::new_or(2.0 * view.dot(*normal) * *normal - *view, normal)
}

impl Material for ModifiedPhong {
    fn eval(&self, at: &Surface, view: Dir3, toward: Dir3) -> Rgb {
        self.value(at.facing(view), view, toward)
    }

    /// One of the two parts is chosen by u.x, whose rest is as uniform as u.x was.
    fn sample(&self, at: &Surface, view: Dir3, u: Vec2) -> Option<Dir3> {
        let (normal, glossy) = (at.facing(view), self.glossy());
        let toward = if u.x < glossy {
            let rest = vec2(u.x / glossy, u.y);
            lobe(mirrored(normal, view), self.exponent, rest)
        } else {
            let rest = vec2((u.x - glossy) / (1.0 - glossy), u.y);
            cosine_hemisphere(normal, rest)
        };
        (toward.dot(*normal) > 0.0).then_some(toward)
    }

    /// What the two parts add up to: the same direction may have been chosen for either.
    fn pdf(&self, at: &Surface, view: Dir3, toward: Dir3) -> f32 {
        let (normal, glossy) = (at.facing(view), self.glossy());
        let cosine = normal.dot(*toward);
        if cosine <= 0.0 {
            return 0.0;
        }
        let cos_alpha = mirrored(normal, view).dot(*toward);
        glossy * lobe_pdf(cos_alpha, self.exponent) + (1.0 - glossy) * cosine_pdf(cosine)
    }
}
