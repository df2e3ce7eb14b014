//! The environment camera: it sees in all directions at once.
//!
//! ```
//! use raybook::camera::{panorama::Panorama, pose::Pose};
//! use raybook::prelude::*;
//!
//! let camera = Panorama { pose: Pose::level(Vec3::ZERO) };
//! assert!(camera.central_ray(vec2(0.5, 0.5)).direction.z < -0.999); // ahead
//! assert!(camera.central_ray(vec2(0.75, 0.5)).direction.x > 0.999); // a quarter turn to the right
//! ```

use crate::camera::{Camera, pose::Pose};
use crate::light::environment::latlong;
use crate::math::ray::Ray;
use glam::Vec2;

/// A camera whose film is a latitude–longitude map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Panorama {
    /// The camera's place and axes.
    pub pose: Pose,
}

impl Camera for Panorama {
    // ANCHOR: panorama_ray
    /// The ray of a place (u, v) on the film. There is no lens.
    ///
    /// Across the film, φ = 2π·(u − ½) goes around, from forward in the middle (φ = 0) to the right (φ = ½π). Down the film,
    /// θ = π·v goes from up to down. Then d = sin θ·(cos φ·forward + sin φ·right) + cos θ·up. For a level pose, the mapping is
    /// the inverse of [`latlong::place`], and the picture is an environment map.
    fn ray(&self, film: Vec2, _lens: Vec2) -> Ray {
        self.pose.ray(latlong::direction(film))
    }
    // ANCHOR_END: panorama_ray
}
