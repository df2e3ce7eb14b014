//! The point light.

use crate::image::rgb::Rgb;
use crate::light::{Light, LightSample};
use crate::math::dir3::Dir3;
use glam::{Vec2, Vec3};

/// A light so small that only its place matters, equally bright to all sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointLight {
    /// Where it is.
    pub position: Vec3,
    /// I: what it sends out, in W/sr; 4π of them are its power.
    pub intensity: Rgb,
}

impl Light for PointLight {
    // ANCHOR: point_light
    /// With r the vector from the point to the light, E = I/|r|² arrives from r/|r|: the same power on ever larger spheres.
    ///
    /// `None` at the light itself, where there is no direction.
    fn sample(&self, at: Vec3, _u: Vec2) -> Option<LightSample> {
        let r = self.position - at;
        Some(LightSample {
            toward: Dir3::new(r)?,
            distance: r.length(),
            arriving: self.intensity / r.length_squared(),
            pdf: f32::INFINITY,
        })
    }
    // ANCHOR_END: point_light
}
