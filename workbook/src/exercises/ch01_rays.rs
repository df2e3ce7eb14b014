//! Chapter 1: `ray_at`, `camera_ray`.

use crate::exercise::exercises;
use crate::record::row;
use glam::{Vec2, Vec3};
use raybook::camera::Camera;
use raybook::camera::pinhole::Pinhole;
use raybook::math::{dir3::Dir3, ray::Ray};

exercises! { ($) ch01_rays
    /// Return the point at distance t along the ray.
    ///
    /// In Rust: a `Dir3` is a `Vec3` of length 1, and `*self.direction` is that vector.
    RayAt: ray_at(
        /// The ray.
        ray: Ray,
        /// The distance along the ray, in metres; negative behind the origin.
        t: f32,
    ) -> (
        /// The point at that distance, in metres.
        point: Vec3,
    ) {
        ray.at(t)
    }

    /// Return the ray from the focal point through the place `film` of the image plane; film (0, 0) is the picture's
    /// top left, (1, 1) its bottom right.
    ///
    /// In Rust: `Dir3::new_or(v, self.forward)` is the direction of a vector v of any length.
    CameraRay: camera_ray(
        /// The focal point, in metres: all rays start here.
        focal_point: Vec3,
        /// Where the camera looks; perpendicular to `right` and `up`.
        forward: Dir3,
        /// To the right along the rows of the picture.
        right: Dir3,
        /// Upwards along the columns of the picture.
        up: Dir3,
        /// The distance from the focal point to the image plane, in metres,
        focal_length: f32 [above 0],
        /// The width and the height of the image plane, in metres.
        plane: Vec2,
        /// The place on the film, in [0, 1]² from the top left, without a unit.
        film: Vec2,
    ) -> (
        /// The ray through that place.
        answer: CameraRayAnswer,
    ) {
        let camera = Pinhole {
            focal_point,
            forward,
            right,
            up,
            focal_length,
            plane,
        };
        camera.central_ray(film).into()
    }
}

row! {
    /// A ray, as it was answered: its direction may have any length.
    pub struct CameraRayAnswer {
        /// Where the ray starts, in metres.
        pub origin: Vec3,
        /// Where the ray goes, of length 1.
        pub direction: Vec3,
    }
}

impl From<Ray> for CameraRayAnswer {
    fn from(ray: Ray) -> Self {
        Self {
            origin: ray.origin,
            direction: *ray.direction,
        }
    }
}
