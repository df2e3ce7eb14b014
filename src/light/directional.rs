//! The directional light.

use crate::image::rgb::Rgb;
use crate::light::{Light, LightSample};
use crate::math::dir3::Dir3;
use glam::{Vec2, Vec3};

/// A light so far away that it comes from the same direction everywhere, and does not fall off: the sun without its disc.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DirectionalLight {
    /// Towards the light.
    pub toward: Dir3,
    /// What arrives on a surface that faces it, in W/m².
    pub irradiance: Rgb,
}

impl Light for DirectionalLight {
    fn sample(&self, _at: Vec3, _u: Vec2) -> Option<LightSample> {
        Some(LightSample {
            toward: self.toward,
            distance: f32::INFINITY,
            arriving: self.irradiance,
            pdf: f32::INFINITY,
        })
    }
}
