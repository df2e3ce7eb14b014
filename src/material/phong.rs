//! The reflection model of Phong.

use crate::image::rgb::Rgb;
use crate::light::LightSample;
use crate::material::Material;
use crate::math::dir3::Dir3;
use crate::sample::hemisphere::{cosine_hemisphere, cosine_pdf};
use crate::shape::Surface;
use glam::Vec2;

/// Ambient, diffuse and specular reflection (Phong, "Illumination for computer generated pictures", 1975).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Phong {
    /// k_a: the share of the ambient light.
    pub ambient: Rgb,
    /// k_d, in 1/sr: radiance per irradiance, the same to all sides; at most 1/π.
    pub diffuse: Rgb,
    /// k_s, in 1/sr: the same at the middle of the highlight.
    pub specular: Rgb,
    /// α: the larger, the smaller and sharper the highlight.
    pub exponent: f32,
}

impl Phong {
    // ANCHOR: phong
    /// k_d (L·N) i + k_s (R·V)^α i for one light, with i what arrives from L, and R = 2 (L·N) N − L its mirror direction.
    ///
    /// A cosine below 0 counts as 0; and behind the surface, where L·N ≤ 0, there is no highlight either.
    pub fn reflect(&self, normal: Dir3, view: Dir3, light: &LightSample) -> Rgb {
        let cosine = light.toward.dot(*normal);
        if cosine <= 0.0 {
            return Rgb::BLACK;
        }
        let mut reflected = self.diffuse * cosine;
        // The power takes longer than all the rest, and a matte surface has no use for it.
        if self.specular != Rgb::BLACK {
            let mirrored = 2.0 * cosine * *normal - *light.toward;
            reflected += self.specular * mirrored.dot(*view).max(0.0).powf(self.exponent);
        }
        reflected * light.arriving
    }
    // ANCHOR_END: phong
}

impl Material for Phong {
    /// f is what light of 1 W/m² becomes, over the cosine that is in it. It grows without bound at the horizon, and the model
    /// sends out more than it gets if k_s is large: it was made to look right, before anybody asked for energy.
    fn eval(&self, at: &Surface, view: Dir3, toward: Dir3) -> Rgb {
        let cosine = at.facing(view).dot(*toward);
        if cosine <= 0.0 {
            return Rgb::BLACK;
        }
        self.lit(at, view, &LightSample::unit(toward)) / cosine
    }

    /// By the cosine: right for the matte part, and possible for the highlight.
    fn sample(&self, at: &Surface, view: Dir3, u: Vec2) -> Option<Dir3> {
        Some(cosine_hemisphere(at.facing(view), u))
    }

    fn pdf(&self, at: &Surface, view: Dir3, toward: Dir3) -> f32 {
        cosine_pdf(at.facing(view).dot(*toward))
    }

    /// The model itself: what arrives comes multiplied by the cosine where the model says so.
    fn lit(&self, at: &Surface, view: Dir3, light: &LightSample) -> Rgb {
        self.reflect(at.facing(view), view, light)
    }

    fn ambient(&self, _at: &Surface) -> Rgb {
        self.ambient
    }
}
