//! The point light.
//!
//! ```
//! use raybook::prelude::*;
//!
//! let lamp = PointLight { position: Vec3::ZERO, intensity: Rgb::WHITE };
//! let arriving = |y| lamp.sample(vec3(0.0, y, 0.0), Vec2::ZERO).map(|sample| sample.arriving.g);
//! assert_eq!((arriving(1.0), arriving(2.0)), (Some(1.0), Some(0.25))); // twice as far: a quarter
//! ```

use crate::image::rgb::Rgb;
use crate::light::{Emitted, Light, LightSample};
use crate::math::{dir3::Dir3, ray::Ray};
use crate::sample::hemisphere::uniform_sphere;
use glam::{Vec2, Vec3};
use std::f32::consts::PI;

/// A light without an extent that shines equally to all sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointLight {
    /// The light's place, in metres.
    pub position: Vec3,
    /// I: the radiant intensity, in W/sr; the light's power is 4π I.
    pub intensity: Rgb,
}

impl Light for PointLight {
    // ANCHOR: point_light
    /// The irradiance E = I/|r|² from the direction r/|r|, where r is the vector from the point to the light: the same power is
    /// spread over a sphere whose area grows as |r|².
    ///
    /// `None` at the light itself, where r has no direction.
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

    fn has_extent(&self) -> bool {
        false
    }

    /// From the light's place, in a direction that is uniform over the sphere: p_ω = 1/4π, so I/p_ω = 4π I, the whole power.
    fn emit(&self, _place: Vec2, direction: Vec2) -> Option<Emitted> {
        Some(Emitted {
            ray: Ray::new(self.position, uniform_sphere(direction)),
            power: self.intensity * (4.0 * PI),
        })
    }
}
