//! The pin-hole camera: every ray passes through one point.

use crate::camera::Camera;
use crate::math::{dir3::Dir3, ray::Ray};
use glam::{Vec2, Vec3};

/// The height of the image plane, in metres: that of the 35 mm film of photographers, whose focal lengths then apply.
pub const PLANE_HEIGHT: f32 = 0.024;

/// The focal length, in metres, of a picture whose vertical field of view is v: h/(2 tan(v/2)).
pub fn focal_length(vertical_degrees: f32) -> f32 {
    0.5 * PLANE_HEIGHT / (0.5 * vertical_degrees).to_radians().tan()
}

/// A focal point, and an image plane in front of it at the focal length.
///
/// The plane of a real pin-hole camera is behind the hole, and its picture upside down; in front, at the same distance,
/// the same rays make it upright.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pinhole {
    /// Where all rays start.
    pub focal_point: Vec3,
    /// Where the camera looks: perpendicular to the image plane.
    pub forward: Dir3,
    /// Along the rows of the picture.
    pub right: Dir3,
    /// Against the columns of the picture.
    pub up: Dir3,
    /// From the focal point to the image plane, in metres.
    pub focal_length: f32,
    /// Width and height of the image plane, in metres.
    pub plane: Vec2,
}

/// Why a camera cannot be placed.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum LookAtError {
    /// There is no direction from the camera to where it looks.
    #[error("the camera at {from} looks at {to}: it needs two different, finite points")]
    SamePoint {
        /// Where the camera is.
        from: Vec3,
        /// Where it looks.
        to: Vec3,
    },
    /// The picture could be turned anyhow.
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
    /// A camera at `from` that sees `to` in the middle of its picture, and `up` towards the top.
    ///
    /// The axes are forward = (to − from)/|to − from|, right ∥ forward × up and, perpendicular to both, right × forward,
    /// which is as near to `up` as the view allows.
    /// `focal_length` is in metres and positive: 0.05 for the photographer's 50 mm, whose view is 2·atan(12/50) = 27° high.
    /// `aspect` is the picture's width over its height.
    ///
    /// # Errors
    /// If `from` and `to` are the same point, or `up` is zero or parallel to the view.
    pub fn look_at(
        from: Vec3,
        to: Vec3,
        up: Vec3,
        focal_length: f32,
        aspect: f32,
    ) -> Result<Self, LookAtError> {
        /// Below this sine of the angle to the view, `up` says too little: the cross product has lost most of its digits.
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
    // ANCHOR: camera_ray
    /// The ray from the focal point through a place on the image plane; `film` as for [`Camera::ray`].
    ///
    /// The centre of pixel (x, y) of w × h is at film = ((x + ½)/w, (y + ½)/h).
    pub fn ray_through(&self, film: Vec2) -> Ray {
        let x = (film.x - 0.5) * self.plane.x;
        let y = (0.5 - film.y) * self.plane.y;
        let toward = self.focal_length * *self.forward + x * *self.right + y * *self.up;
        Ray::new(self.focal_point, Dir3::new_or(toward, self.forward))
    }
    // ANCHOR_END: camera_ray
}

impl Camera for Pinhole {
    fn ray(&self, film: Vec2, _lens: Vec2) -> Ray {
        self.ray_through(film)
    }
}
