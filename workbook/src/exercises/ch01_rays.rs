//! Chapter 1: `ray_at`, `camera_ray`.

use raybook::camera::pinhole::Pinhole;
use raybook::math::{dir3::Dir3, ray::Ray};
use crate::exercise::{Asked, Exercise};
use crate::row::row;
use glam::{Vec2, Vec3};

/// This chapter's exercises, in order.
pub const EXERCISES: &[&dyn Asked] = &[&RayAt, &CameraRay];

/// See [`Exercise::TASK`].
pub struct RayAt;

row! {
    /// A ray and a distance.
    pub struct RayAtQuestion {
        /// The ray.
        pub ray: Ray,
        /// The distance along it.
        pub t: f32,
    }
}

impl Exercise for RayAt {
    type Question = RayAtQuestion;
    type Answer = Vec3;
    const NAME: &'static str = "ray_at";
    const ANSWER: &'static str = "point";
    const TASK: &'static str = "Return the point at distance t along the ray.";

    fn answer(q: &Self::Question) -> Self::Answer {
        q.ray.at(q.t)
    }
}

/// See [`Exercise::TASK`].
pub struct CameraRay;

row! {
    /// A pin-hole camera and a place on its film.
    pub struct CameraRayQuestion {
        /// Where all rays start.
        pub focal_point: Vec3,
        /// Where the camera looks.
        pub forward: Dir3,
        /// Along the rows of the picture.
        pub right: Dir3,
        /// Against the columns of the picture.
        pub up: Dir3,
        /// From the focal point to the image plane.
        pub focal_length: f32,
        /// Width and height of the image plane.
        pub plane: Vec2,
        /// In [0, 1]², from the top left.
        pub film: Vec2,
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

impl Exercise for CameraRay {
    type Question = CameraRayQuestion;
    type Answer = CameraRayAnswer;
    const NAME: &'static str = "camera_ray";
    const TASK: &'static str = "Return the ray from the focal point through the place `film` of the image plane; \
        film (0, 0) is the picture's top left, (1, 1) its bottom right.";

    fn answer(q: &Self::Question) -> Self::Answer {
        let Self::Question {
            focal_point,
            forward,
            right,
            up,
            focal_length,
            plane,
            film,
        } = *q;
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
