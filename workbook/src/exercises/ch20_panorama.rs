//! Chapter 20: `panorama_ray`.

use raybook::camera::{panorama::Panorama, pose::Pose};
use raybook::math::dir3::Dir3;
use crate::exercise::exercises;
use crate::exercises::ch01_rays::CameraRayAnswer;
use glam::{Vec2, Vec3};

exercises! { ($) ch20_panorama
    /// Return the ray from `position` for the place `film` of a panorama, from film (0, 0) at its top left to (1, 1) at
    /// its bottom right: across the picture the angle around `up` grows evenly, with `forward` in the middle, `right` a
    /// quarter of the width to the right of it and -forward at both edges; down the picture the angle from `up` grows
    /// evenly, from `up` at the top edge to -up at the bottom edge.
    PanoramaRay: panorama_ray(
        /// Where all rays start.
        position: Vec3,
        /// What is in the middle of the picture.
        forward: Dir3,
        /// A quarter of the picture's width to the right of that.
        right: Dir3,
        /// The top edge of the picture.
        up: Dir3,
        /// In [0, 1]², from the top left.
        film: Vec2,
    ) -> (
        /// Answer.
        answer: CameraRayAnswer,
    ) {
        let pose = Pose {
            position,
            forward,
            right,
            up,
        };
        Panorama { pose }.ray_through(film).into()
    }
}
