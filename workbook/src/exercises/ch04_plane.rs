//! Chapter 4: `plane_hit`.

use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::{Shape, plane::Plane};
use crate::exercise::exercises;

exercises! { ($) ch04_plane
    /// Return the distance t in the interval (min < t < max) at which the ray meets the plane n·p = offset, as `Hit {
    /// t, uv: Vec2::ZERO, id: 0 }`, or None.
    PlaneHit: plane_hit(
        /// The ray.
        ray: Ray,
        /// Only t with min < t < max counts.
        within: Interval,
        /// n: square to the plane.
        normal: Dir3,
        /// The plane holds all p with n·p = offset.
        offset: f32,
    ) -> (
        /// T.
        t: Option<f32>,
    ) {
        Plane {
            normal,
            offset,
        }
        .hit(&ray, within)
        .map(|hit| hit.t)
    }
}
