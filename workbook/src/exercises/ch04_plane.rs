//! Chapter 4: `plane_hit`.

use crate::exercise::exercises;
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::{Shape, plane::Plane};

exercises! { ($) ch04_plane
    /// Return the distance t at which the ray meets the plane n·p = offset. It counts only if min < t < max; else there
    /// is no answer. A ray that runs within the plane does not meet it.
    ///
    /// In Rust: the distance as `Some(Hit { t, uv: Vec2::ZERO, id: 0 })`.
    PlaneHit: plane_hit(
        /// The ray.
        ray: Ray,
        /// The distances that count: min < t < max, in metres.
        within: Interval,
        /// n: perpendicular to the plane.
        normal: Dir3,
        /// The plane holds all p with n·p = offset, in metres.
        offset: f32,
    ) -> (
        /// The distance along the ray, in metres; none for a miss.
        t: Option<f32>,
    ) {
        let plane = Plane { normal, offset };
        plane.hit(&ray, within).map(|hit| hit.t)
    }
}
