//! Phong's reflection model.
//!
//! ```
//! use raybook::light::LightSample;
//! use raybook::prelude::*;
//!
//! let phong = Phong { ambient: Rgb::BLACK, diffuse: Rgb::gray(0.2), specular: Rgb::gray(0.5), exponent: 20.0 };
//! let light = LightSample::unit(Dir3::new(vec3(0.6, 0.8, 0.0)).expect("longer than 0"));
//! let mirrored = Dir3::new(vec3(-0.6, 0.8, 0.0)).expect("longer than 0");
//! // In the mirror direction: k_d (L·N) + k_s = 0.2 · 0.8 + 0.5.
//! assert!((phong.reflect(Dir3::Y, mirrored, &light).g - 0.66).abs() < 1e-5);
//! ```

use crate::image::rgb::Rgb;
use crate::light::LightSample;
use crate::material::Material;
use crate::math::dir3::Dir3;
use crate::shape::Surface;

/// Ambient, diffuse and specular reflection (Phong, "Illumination for computer generated pictures", 1975).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Phong {
    /// k_a: the share of the ambient light that is reflected.
    pub ambient: Rgb,
    /// k_d, in 1/sr: reflected radiance per irradiance, the same to all sides; at most 1/π.
    pub diffuse: Rgb,
    /// k_s, in 1/sr: reflected radiance per irradiance in the middle of the highlight.
    pub specular: Rgb,
    /// α: the exponent; the larger α, the smaller and sharper the highlight.
    pub exponent: f32,
}

impl Phong {
    // ANCHOR: phong
    /// The radiance k_d (L·N) i + k_s (R·V)^α i for one light. i is the irradiance that arrives from L, and R = 2 (L·N) N − L the
    /// mirror direction of L.
    ///
    /// A cosine below 0 counts as 0. Behind the surface, where L·N ≤ 0, there is no highlight either.
    pub fn reflect(&self, normal: Dir3, view: Dir3, light: &LightSample) -> Rgb {
        let cosine = light.toward.dot(*normal);
        if cosine <= 0.0 {
            return Rgb::BLACK;
        }
        let mut reflected = self.diffuse * cosine;
        // The power takes longer than everything else, and a matte surface does not need it.
        if self.specular != Rgb::BLACK {
            let mirrored = 2.0 * cosine * *normal - *light.toward;
            reflected += self.specular * mirrored.dot(*view).max(0.0).powf(self.exponent);
        }
        reflected * light.arriving
    }
    // ANCHOR_END: phong
}

impl Material for Phong {
    /// f is the reflected radiance for 1 W/m², over the cosine L·N. It grows without bound at the horizon, and for a large k_s
    /// the model reflects more energy than arrives: it is an empirical model, not a physical one.
    fn eval(&self, at: &Surface, view: Dir3, toward: Dir3) -> Rgb {
        per_cosine(self, at, view, toward)
    }

    /// The model itself: it multiplies the matte part by the cosine, but not the highlight.
    fn lit(&self, at: &Surface, view: Dir3, light: &LightSample) -> Rgb {
        self.reflect(at.facing(view), view, light)
    }

    fn ambient(&self, _at: &Surface) -> Rgb {
        self.ambient
    }
}

/// f of a model that is given by the radiance it reflects: the radiance for 1 W/m² from `toward`, over the cosine that it contains.
pub(super) fn per_cosine(model: &impl Material, at: &Surface, view: Dir3, toward: Dir3) -> Rgb {
    let cosine = at.facing(view).dot(*toward);
    if cosine <= 0.0 {
        return Rgb::BLACK;
    }
    model.lit(at, view, &LightSample::unit(toward)) / cosine
}
