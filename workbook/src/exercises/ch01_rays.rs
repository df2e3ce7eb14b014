//! Chapter 1: `ray_at`, `camera_ray`.

use raybook::camera::pinhole::Pinhole;
use raybook::math::{dir3::Dir3, ray::Ray};
use crate::exercise::exercises;
use crate::record::row;
use glam::{Vec2, Vec3};

exercises! { ($) ch01_rays
    /// Return the point at distance t along the ray.
    RayAt: ray_at(
        /// The ray.
        ray: Ray,
        /// The distance along it.
        t: f32,
    ) -> (
        /// Point.
        point: Vec3,
    ) {
        ray.at(t)
    }

    /// Return the ray from the focal point through the place `film` of the image plane; film (0, 0) is the picture's
    /// top left, (1, 1) its bottom right.
    CameraRay: camera_ray(
        /// Where all rays start.
        focal_point: Vec3,
        /// Where the camera looks.
        forward: Dir3,
        /// Along the rows of the picture.
        right: Dir3,
        /// Against the columns of the picture.
        up: Dir3,
        /// From the focal point to the image plane.
        focal_length: f32,
        /// Width and height of the image plane.
        plane: Vec2,
        /// In [0, 1]², from the top left.
        film: Vec2,
    ) -> (
        /// Answer.
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
        camera.ray_through(film).into()
    }
}

row! {
    /// A ray, as it was answered: its direction may have any length.
    pub struct CameraRayAnswer {
        /// Where it starts.
        pub origin: Vec3,
        /// Where it goes.
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
