//! A camera's place and its axes.
//!
//! ```
//! use raybook::camera::pose::Pose;
//! use raybook::prelude::*;
//!
//! // A camera that looks along +x: what it has ahead, −z in its coordinates, is +x in the world.
//! let pose = Pose { position: Vec3::ZERO, forward: Dir3::X, right: Dir3::Z, up: Dir3::Y };
//! assert_eq!(pose.ray(-Dir3::Z).direction, Dir3::X);
//! assert_eq!(pose.seen(Dir3::X), -Dir3::Z);
//! ```

use crate::camera::pinhole::Pinhole;
use crate::math::{dir3::Dir3, ray::Ray};
use glam::{Vec3, vec3};

/// A place and three perpendicular axes, right × up = −forward: all that a camera without an image plane needs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Where the rays start, in metres.
    pub position: Vec3,
    /// Where the camera looks.
    pub forward: Dir3,
    /// The direction to the right in the picture.
    pub right: Dir3,
    /// The direction upwards in the picture.
    pub up: Dir3,
}

impl Pose {
    /// A level pose along the world's axes: forward is −z, right is +x, up is +y.
    ///
    /// The picture of a [`Panorama`](crate::camera::panorama::Panorama) with this pose is an environment map.
    pub fn level(position: Vec3) -> Self {
        Self {
            position,
            forward: -Dir3::Z,
            right: Dir3::X,
            up: Dir3::Y,
        }
    }

    // ANCHOR: pose_ray
    /// The ray in a direction (x, y, z) of the camera's coordinates: x to the right, y up, −z forward.
    pub fn ray(&self, toward: Dir3) -> Ray {
        let d = toward.x * *self.right + toward.y * *self.up - toward.z * *self.forward;
        Ray::new(self.position, Dir3::new_or(d, self.forward))
    }
    // ANCHOR_END: pose_ray

    /// A direction of the world in the camera's coordinates: the inverse of [`Pose::ray`].
    pub fn seen(&self, toward: Dir3) -> Dir3 {
        let [x, y, ahead] = [self.right, self.up, self.forward].map(|axis| axis.dot(*toward));
        Dir3::new_or(vec3(x, y, -ahead), toward)
    }
}

impl From<Pinhole> for Pose {
    /// The place and the axes of a pin-hole camera.
    fn from(camera: Pinhole) -> Self {
        Self {
            position: camera.focal_point,
            forward: camera.forward,
            right: camera.right,
            up: camera.up,
        }
    }
}
