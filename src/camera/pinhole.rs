//! The pin-hole camera: every ray passes through one point.
//!
//! ```
//! use raybook::prelude::*;
//!
//! let camera = Pinhole::look_at(vec3(0.0, 0.0, 5.0), Vec3::ZERO, Vec3::Y, 0.050, 1.5)?;
//! assert_eq!((camera.forward, camera.right, camera.up), (-Dir3::Z, Dir3::X, Dir3::Y));
//! assert!((focal_length(27.0) - 0.050).abs() < 1e-4); // 50 mm see 27° vertically
//! # Ok::<(), raybook::camera::pinhole::LookAtError>(())
//! ```

use crate::camera::Camera;
use crate::math::{dir3::Dir3, ray::Ray};
use glam::{Vec2, Vec3};

/// The height of the image plane, in metres: that of a photographer's 35 mm film, so that the usual focal lengths apply.
pub const PLANE_HEIGHT: f32 = 0.024;

/// The focal length, in metres, for the vertical field of view v in degrees: h/(2 tan(v/2)), h = [`PLANE_HEIGHT`].
pub fn focal_length(vertical_degrees: f32) -> f32 {
    0.5 * PLANE_HEIGHT / (0.5 * vertical_degrees).to_radians().tan()
}

/// A pin-hole camera: a focal point, and an image plane in front of this point, at the focal length.
///
/// In a real pin-hole camera the plane is behind the hole, and the picture on it is upside down. On a plane in front of the hole,
/// at the same distance, the same rays make an upright picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pinhole {
    /// Where all rays start, in metres.
    pub focal_point: Vec3,
    /// Where the camera looks: perpendicular to the image plane.
    pub forward: Dir3,
    /// Along the rows of the picture.
    pub right: Dir3,
    /// Upwards in the picture; its rows are counted downwards.
    pub up: Dir3,
    /// From the focal point to the image plane, in metres.
    pub focal_length: f32,
    /// Width and height of the image plane, in metres.
    pub plane: Vec2,
}

/// Why a camera cannot be placed.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum LookAtError {
    /// The camera is at the point that it looks at, or a coordinate is not finite.
    #[error("the camera at {from} looks at {to}: it needs two different, finite points")]
    SamePoint {
        /// Where the camera is.
        from: Vec3,
        /// Where it looks.
        to: Vec3,
    },
    /// Up is parallel to forward: the picture could be turned by any angle.
    #[error(
        "the camera looks along {forward}, and its up, {up}, is zero or parallel to that: choose another up"
    )]
    UpParallelToView {
        /// Where the camera looks.
        forward: Vec3,
        /// The up that was asked for.
        up: Vec3,
    },
}

impl Pinhole {
    // ANCHOR: look_at
    /// A camera at `from` that sees `to` in the middle of its picture, and the direction `up` towards the top.
    ///
    /// The axes are forward = (to − from)/|to − from|, right = (forward × up)/|forward × up|, and up = right × forward, which is
    /// the direction nearest to `up` that is perpendicular to forward.
    /// `focal_length` is in metres and positive: 0.05 for the photographer's 50 mm, whose view is 2·atan(12/50) = 27° high.
    /// `aspect` is the picture's width over its height.
    ///
    /// # Errors
    /// If `from` and `to` are the same point, `up` is zero or parallel to the view, or a coordinate is not finite.
    pub fn look_at(
        from: Vec3,
        to: Vec3,
        up: Vec3,
        focal_length: f32,
        aspect: f32,
    ) -> Result<Self, LookAtError> {
        /// The least sine of the angle between `up` and the view: below it, the cross product has lost most of its digits.
        const SMALLEST_SINE: f32 = 1e-4;
        let forward = Dir3::new(to - from).ok_or(LookAtError::SamePoint { from, to })?;
        let parallel = LookAtError::UpParallelToView {
            forward: *forward,
            up,
        };
        let sideways = forward.cross(*Dir3::new(up).ok_or(parallel)?);
        let right = Dir3::new(sideways)
            .filter(|_| sideways.length() > SMALLEST_SINE)
            .ok_or(parallel)?;
        let up = Dir3::new_or(right.cross(*forward), right);
        let plane = Vec2::new(PLANE_HEIGHT * aspect, PLANE_HEIGHT);
        Ok(Self {
            focal_point: from,
            forward,
            right,
            up,
            focal_length,
            plane,
        })
    }

    // ANCHOR_END: look_at
}

impl Camera for Pinhole {
    // ANCHOR: camera_ray
    /// The ray from the focal point through a place on the image plane. A pin-hole has no lens.
    ///
    /// The centre of pixel (x, y) of w × h is at film = ((x + ½)/w, (y + ½)/h).
    fn ray(&self, film: Vec2, _lens: Vec2) -> Ray {
        let x = (film.x - 0.5) * self.plane.x;
        let y = (0.5 - film.y) * self.plane.y;
        let toward = self.focal_length * *self.forward + x * *self.right + y * *self.up;
        Ray::new(self.focal_point, Dir3::new_or(toward, self.forward))
    }
    // ANCHOR_END: camera_ray
}
