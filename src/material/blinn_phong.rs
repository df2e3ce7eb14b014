//! Blinn's variant of Phong's model.

use crate::image::rgb::Rgb;
use crate::light::LightSample;
use crate::material::{Material, phong::Phong};
use crate::math::dir3::Dir3;
use crate::shape::Surface;

/// As [`Phong`], with (N·H)^α in the place of (R·V)^α (Blinn, "Models of light reflection for computer synthesized
/// pictures", 1977).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BlinnPhong(pub Phong);

impl BlinnPhong {
    // ANCHOR: blinn_phong
    /// k_d (L·N) i + k_s (N·H)^α i for one light, with H = (L + V)/|L + V|, half way between light and viewer.
    ///
    /// If L = −V there is no H and no highlight.
    pub fn reflect(&self, normal: Dir3, view: Dir3, light: &LightSample) -> Rgb {
        let cosine = light.toward.dot(*normal);
        if cosine <= 0.0 {
            return Rgb::BLACK;
        }
        let half = Dir3::new(*light.toward + *view);
        let highlight = half.map_or(0.0, |h| h.dot(*normal).max(0.0).powf(self.0.exponent));
        (self.0.diffuse * cosine + self.0.specular * highlight) * light.arriving
    }
    // ANCHOR_END: blinn_phong
}

impl Material for BlinnPhong {
    fn lit(&self, at: &Surface, view: Dir3, light: &LightSample) -> Rgb {
        self.reflect(at.facing(view), view, light)
    }

    fn ambient(&self, at: &Surface) -> Rgb {
        self.0.ambient(at)
    }
}
