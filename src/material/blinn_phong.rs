//! Blinn's variant of Phong's model.
//!
//! ```
//! use raybook::light::LightSample;
//! use raybook::material::blinn_phong::BlinnPhong;
//! use raybook::prelude::*;
//!
//! let phong = Phong { ambient: Rgb::BLACK, diffuse: Rgb::BLACK, specular: Rgb::WHITE, exponent: 20.0 };
//! let light = LightSample::unit(Dir3::new(vec3(0.6, 0.8, 0.0)).expect("longer than 0"));
//! // Beside the mirror direction, the angle between N and H is half of that between R and V.
//! let [wide, narrow] = [BlinnPhong(phong).reflect(Dir3::Y, Dir3::Y, &light), phong.reflect(Dir3::Y, Dir3::Y, &light)];
//! assert!(wide.g > 5.0 * narrow.g);
//! ```

use crate::image::rgb::Rgb;
use crate::light::LightSample;
use crate::material::Material;
use crate::material::phong::{Phong, per_cosine};
use crate::math::dir3::Dir3;
use crate::shape::Surface;

/// [`Phong`]'s model with (N·H)^α instead of (R·V)^α (Blinn, "Models of light reflection for computer synthesized
/// pictures", 1977).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BlinnPhong(pub Phong);

impl BlinnPhong {
    // ANCHOR: blinn_phong
    /// The radiance k_d (L·N) i + k_s (N·H)^α i for one light. i is the irradiance that arrives from L, and H = (L + V)/|L + V|
    /// the halfway vector between light and viewer.
    ///
    /// Behind the surface, L·N ≤ 0, the radiance is 0. If L = −V there is no H, and no highlight.
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
    /// [`BlinnPhong::reflect`] for 1 W/m², over the cosine L·N that it contains.
    fn eval(&self, at: &Surface, view: Dir3, toward: Dir3) -> Rgb {
        per_cosine(self, at, view, toward)
    }

    /// The model itself: it multiplies the matte part by the cosine, but not the highlight.
    fn lit(&self, at: &Surface, view: Dir3, light: &LightSample) -> Rgb {
        self.reflect(at.facing(view), view, light)
    }

    fn ambient(&self, at: &Surface) -> Rgb {
        self.0.ambient(at)
    }
}
