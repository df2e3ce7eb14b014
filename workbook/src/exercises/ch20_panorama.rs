//! Chapter 20: `panorama_ray`.

use crate::exercise::exercises;
use crate::exercises::ch01_rays::CameraRayAnswer;
use glam::{Vec2, Vec3};
use raybook::camera::Camera;
use raybook::camera::{panorama::Panorama, pose::Pose};
use raybook::math::dir3::Dir3;

exercises! { ($) ch20_panorama
    /// Return the ray from `position` for a place of a panorama. Across the picture the angle around `up` grows evenly:
    /// `forward` is in the middle, `right` a quarter of the width to the right of it, -forward at both edges. Down the
    /// picture the angle from `up` grows evenly, from `up` to -up.
    PanoramaRay: panorama_ray(
        /// The position of the camera, in metres: all rays start here.
        position: Vec3,
        /// The direction in the middle of the picture; perpendicular to `right` and `up`.
        forward: Dir3,
        /// The direction a quarter of the picture's width to the right of the middle.
        right: Dir3,
        /// The direction at the top edge of the picture.
        up: Dir3,
        /// The place on the film, in [0, 1]² from the top left, without a unit.
        film: Vec2,
    ) -> (
        /// The ray for that place.
        answer: CameraRayAnswer,
    ) {
        let pose = Pose {
            position,
            forward,
            right,
            up,
        };
        Panorama { pose }.central_ray(film).into()
    }
}
