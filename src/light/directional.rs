//! The directional light.
//!
//! ```
//! use raybook::prelude::*;
//!
//! let sun = DirectionalLight { toward: Dir3::Y, irradiance: Rgb::gray(900.0) };
//! let near = sun.sample(Vec3::ZERO, Vec2::ZERO);
//! assert_eq!(near, sun.sample(vec3(0.0, -1000.0, 0.0), Vec2::ZERO)); // the same everywhere
//! ```

use crate::image::rgb::Rgb;
use crate::light::{Light, LightSample};
use crate::math::dir3::Dir3;
use glam::{Vec2, Vec3};

/// A light at infinity: its light comes from the same direction everywhere and does not fall off. It is the sun without the disc.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DirectionalLight {
    /// The direction towards the light.
    pub toward: Dir3,
    /// The irradiance of a surface that faces the light, in W/m².
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

    fn has_extent(&self) -> bool {
        false
    }
}
