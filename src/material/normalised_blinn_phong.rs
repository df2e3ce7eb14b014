//! Blinn's variant of Phong's model as a physical BRDF: reciprocal and energy-conserving.

use crate::image::rgb::Rgb;
use crate::material::Material;
use crate::material::mirror::reflect;
use crate::material::modified_phong::glossy_share;
use crate::math::dir3::Dir3;
use crate::sample::hemisphere::{cosine_hemisphere, cosine_pdf, lobe, lobe_pdf};
use crate::shape::Surface;
use glam::{Vec2, vec2};
use std::f32::consts::{FRAC_1_PI, PI};

/// A matte part and a glossy one, whose highlight is a power of N·H (Blinn, "Models of light reflection for computer synthesized
/// pictures", 1977). It reflects no more light than arrives if ρ_d + ρ_s ≤ 1.
///
/// ```
/// use raybook::material::normalised_blinn_phong::NormalisedBlinnPhong;
/// use raybook::prelude::*;
///
/// let [diffuse, specular] = [Rgb::gray(0.5), Rgb::gray(0.3)];
/// let glossy = NormalisedBlinnPhong { diffuse, specular, exponent: 100.0 };
/// let sharper = NormalisedBlinnPhong { exponent: 1000.0, ..glossy };
/// let up = |material: NormalisedBlinnPhong| material.value(Dir3::Y, Dir3::Y, Dir3::Y).g;
/// assert!(up(sharper) > 5.0 * up(glossy), "a smaller highlight is brighter");
/// ```
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
    /// 8π (2^(−n/2) + n)/((n + 2)(n + 4)), so that the share ρ_s leaves in the highlight (Giesen, "Phong and Blinn-Phong
    /// normalization factors", 2009). f does not contain the cosine of the light's direction, which belongs to the irradiance. f is 0
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

    /// The probability with which a direction is chosen from the highlight.
    fn glossy(&self) -> f32 {
        glossy_share(self.diffuse, self.specular)
    }
}

impl Material for NormalisedBlinnPhong {
    fn eval(&self, at: &Surface, view: Dir3, toward: Dir3) -> Rgb {
        self.value(at.facing(view), view, toward)
    }

    /// u.x chooses one of the two parts; what is left of u.x is scaled to [0, 1), where it is uniform again. For the highlight, H
    /// is chosen with a density proportional to (N·H)ⁿ, and the viewer is mirrored at H.
    fn sample(&self, at: &Surface, view: Dir3, u: Vec2) -> Option<Dir3> {
        let (normal, glossy) = (at.facing(view), self.glossy());
        let toward = if u.x < glossy {
            let half = lobe(normal, self.exponent, vec2(u.x / glossy, u.y));
            reflect(-view, half)
        } else {
            let rest = vec2((u.x - glossy) / (1.0 - glossy), u.y);
            cosine_hemisphere(normal, rest)
        };
        (toward.dot(*normal) > 0.0).then_some(toward)
    }

    /// The weighted sum of both parts' densities. That of the highlight is the density of H over 4 (V·H), the factor between solid
    /// angles of H and of the mirror direction (Torrance and Sparrow 1967).
    fn pdf(&self, at: &Surface, view: Dir3, toward: Dir3) -> f32 {
        let (normal, glossy) = (at.facing(view), self.glossy());
        let cosine = normal.dot(*toward);
        if cosine <= 0.0 {
            return 0.0;
        }
        let highlight = Dir3::new(*view + *toward).map_or(0.0, |half| {
            lobe_pdf(normal.dot(*half), self.exponent) / (4.0 * view.dot(*half))
        });
        glossy * highlight + (1.0 - glossy) * cosine_pdf(cosine)
    }
}
