//! The bidirectional reflectance distribution function, and the material that it makes.

use crate::image::rgb::Rgb;
use crate::light::LightSample;
use crate::material::Material;
use crate::math::dir3::Dir3;
use crate::shape::Surface;
use glam::Vec2;

// ANCHOR: brdf
/// How a surface reflects: f = dL_o/dE, the radiance towards a viewer per irradiance from a direction, in 1/sr.
///
/// `view` and `toward` are the directions from the surface to the viewer and to where the light comes from. A BRDF of nature is
/// reciprocal, f(ω_i, ω_o) = f(ω_o, ω_i), and sends out no more than it gets: ∫ f cos θ dω ≤ 1 over the hemisphere
/// (Nicodemus et al. 1977).
pub trait Brdf: Send + Sync {
    /// f, in 1/sr; 0 where light or viewer is behind the surface.
    fn eval(&self, at: &Surface, view: Dir3, toward: Dir3) -> Rgb;

    /// A direction from which much of the light that the viewer gets may come: about as likely as f cos θ.
    ///
    /// u is uniform in [0, 1)². `None`: behind the surface, from where nothing comes.
    fn sample(&self, at: &Surface, view: Dir3, u: Vec2) -> Option<Dir3>;

    /// The density with which [`Brdf::sample`] chooses a direction, in 1/sr.
    fn pdf(&self, at: &Surface, view: Dir3, toward: Dir3) -> f32;

    /// L_e: the radiance that the surface sends out by itself.
    fn emitted(&self, _at: &Surface, _view: Dir3) -> Rgb {
        Rgb::BLACK
    }

    /// f cos θ E: the radiance that light from a lamp becomes.
    fn reflect(&self, at: &Surface, view: Dir3, light: &LightSample) -> Rgb {
        let cosine = at.facing(view).dot(*light.toward).max(0.0);
        self.eval(at, view, light.toward) * light.arriving * cosine
    }
}
// ANCHOR_END: brdf

/// A BRDF as a [`Material`]: for Whitted's way of tracing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reflecting<B>(pub B);

impl<B: Brdf> Material for Reflecting<B> {
    fn lit(&self, at: &Surface, view: Dir3, light: &LightSample) -> Rgb {
        self.0.reflect(at, view, light)
    }
}
