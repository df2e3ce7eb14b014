//! Where a camera is, and how it is turned.

use crate::camera::pinhole::Pinhole;
use crate::math::{dir3::Dir3, ray::Ray};
use glam::{Vec3, vec3};

/// A place, and three axes at right angles, right × up = −forward: all that a camera without an image plane needs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Where the rays start.
    pub position: Vec3,
    /// Where the camera looks.
    pub forward: Dir3,
    /// Right of that.
    pub right: Dir3,
    /// Above it.
    pub up: Dir3,
}

impl Pose {
    /// Level, and along the world's axes: forward is −z, right +x, up +y.
    ///
    /// The directions on the film are then those of an environment map, and the picture is one.
    pub fn level(position: Vec3) -> Self {
        Self {
            position,
            forward: -Dir3::Z,
            right: Dir3::X,
            up: Dir3::Y,
        }
    }

    // ANCHOR: pose_ray
    /// The ray in a direction (x, y, z) as the camera sees it: x to its right, y above it, −z ahead of it.
    pub fn ray(&self, toward: Dir3) -> Ray {
        let d = toward.x * *self.right + toward.y * *self.up - toward.z * *self.forward;
        Ray::new(self.position, Dir3::new_or(d, self.forward))
    }
    // ANCHOR_END: pose_ray

    /// A direction of the world as the camera sees it: the inverse of [`Pose::ray`].
    pub fn seen(&self, toward: Dir3) -> Dir3 {
        let [x, y, ahead] = [self.right, self.up, self.forward].map(|axis| axis.dot(*toward));
        Dir3::new_or(vec3(x, y, -ahead), toward)
    }
}

impl From<Pinhole> for Pose {
    /// Where a pin-hole camera stands, and as it is turned.
    fn from(camera: Pinhole) -> Self {
        Self {
            position: camera.focal_point,
            forward: camera.forward,
            right: camera.right,
            up: camera.up,
        }
    }
}
