//! The reflection model of Phong.

use crate::image::rgb::Rgb;
use crate::light::LightSample;
use crate::material::Material;
use crate::math::dir3::Dir3;
use crate::shape::Surface;

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
    fn lit(&self, at: &Surface, view: Dir3, light: &LightSample) -> Rgb {
        self.reflect(at.facing(view), view, light)
    }

    fn ambient(&self, _at: &Surface) -> Rgb {
        self.ambient
    }
}
