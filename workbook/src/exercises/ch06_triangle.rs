//! Chapter 6: `triangle_hit`, `triangle_normal`.

use raybook::math::{interval::Interval, ray::Ray};
use raybook::shape::{Shape, triangle::Triangle};
use crate::exercise::exercises;
use crate::record::row;
use glam::Vec3;

exercises! { ($) ch06_triangle
    /// Return where the ray meets the triangle with min < t < max, from either side, as `Hit { t, uv: (b1, b2), id: 0
    /// }`, or None; the point is p0 + b1·e1 + b2·e2.
    TriangleHit: triangle_hit(
        /// The ray.
        ray: Ray,
        /// Only t with min < t < max counts.
        within: Interval,
        /// The first corner.
        p0: Vec3,
        /// The second corner.
        p1: Vec3,
        /// The third corner.
        p2: Vec3,
    ) -> (
        /// Answer.
        answer: Option<TriangleHitAnswer>,
    ) {
        Triangle::new(p0, p1, p2)
            .hit(&ray, within)
            .map(|hit| TriangleHitAnswer {
                t: hit.t,
                b1: hit.uv.x,
                b2: hit.uv.y,
            })
    }

    /// Return the unit normal of the side from which p0, p1, p2 run counter-clockwise, or None for a triangle without
    /// area.
    TriangleNormal: triangle_normal(
        /// The first corner.
        p0: Vec3,
        /// The second corner.
        p1: Vec3,
        /// The third corner.
        p2: Vec3,
    ) -> (
        /// Normal.
        normal: Option<Vec3>,
    ) {
        Triangle::new(p0, p1, p2).normal().map(|n| *n)
    }
}

row! {
    /// Where a triangle is hit.
    pub struct TriangleHitAnswer {
        /// The distance along the ray.
        pub t: f32,
        /// The weight of the second corner.
        pub b1: f32,
        /// The weight of the third corner.
        pub b2: f32,
    }
}
