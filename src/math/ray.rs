//! A ray: where light travels.
//!
//! ```
//! use raybook::prelude::*;
//!
//! let ray = Ray::new(vec3(1.0, 2.0, 3.0), Dir3::X);
//! assert_eq!(ray.at(4.0), vec3(5.0, 2.0, 3.0)); // after 4 m
//! ```

use crate::math::dir3::Dir3;
use glam::Vec3;

/// A half line from a point in a direction: r(t) = o + t·d.
///
/// The direction has length 1, so t is a distance in metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// o: where the ray starts, in metres.
    pub origin: Vec3,
    /// d: the direction in which it goes.
    pub direction: Dir3,
}

impl Ray {
    /// A ray from a point in a direction.
    #[inline]
    pub fn new(origin: Vec3, direction: Dir3) -> Self {
        Self { origin, direction }
    }

    // ANCHOR: ray_at
    /// The point at the distance t, in metres: r(t) = o + t·d.
    #[inline]
    pub fn at(&self, t: f32) -> Vec3 {
        self.origin + t * *self.direction
    }
    // ANCHOR_END: ray_at
}
