//! Chapter 20: `panorama_ray`.

use raybook::camera::{panorama::Panorama, pose::Pose};
use raybook::math::dir3::Dir3;
use crate::exercise::{Asked, Exercise};
use crate::exercises::ch01_rays::CameraRayAnswer;
use crate::row::row;
use glam::{Vec2, Vec3};

/// This chapter's exercises, in order.
pub const EXERCISES: &[&dyn Asked] = &[&PanoramaRay];

/// See [`Exercise::TASK`].
pub struct PanoramaRay;

row! {
    /// A camera that sees all around, and a place on its film.
    pub struct PanoramaRayQuestion {
        /// Where all rays start.
        pub position: Vec3,
        /// What is in the middle of the picture.
        pub forward: Dir3,
        /// A quarter of the picture's width to the right of that.
        pub right: Dir3,
        /// The top edge of the picture.
        pub up: Dir3,
        /// In [0, 1]², from the top left.
        pub film: Vec2,
    }
}

impl Exercise for PanoramaRay {
    type Question = PanoramaRayQuestion;
    type Answer = CameraRayAnswer;
    const NAME: &'static str = "panorama_ray";
    const TASK: &'static str = "Return the ray from `position` for the place `film` of a panorama, \
        from film (0, 0) at its top left to (1, 1) at its bottom right: \
        across the picture the angle around `up` grows evenly, with `forward` in the middle, `right` a quarter of the width \
        to the right of it and -forward at both edges; down the picture the angle from `up` grows evenly, \
        from `up` at the top edge to -up at the bottom edge.";

    fn answer(q: &Self::Question) -> Self::Answer {
        let Self::Question {
            position,
            forward,
            right,
            up,
            film,
        } = *q;
        let pose = Pose {
            position,
            forward,
            right,
            up,
        };
        Panorama { pose }.ray_through(film).into()
    }
}
