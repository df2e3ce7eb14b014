//! Chapter 6: `triangle_hit`, `triangle_normal`.

use crate::exercise::exercises;
use crate::record::row;
use glam::Vec3;
use raybook::math::{interval::Interval, ray::Ray};
use raybook::shape::{Shape, triangle::Triangle};

exercises! { ($) ch06_triangle
    /// Return where the ray meets the triangle with min < t < max, from either side: the distance t and the weights b1
    /// and b2. The point of the hit is p0 + b1·(p1 − p0) + b2·(p2 − p0). There is no answer if the ray misses.
    ///
    /// In Rust: `Some(Hit { t, uv: vec2(b1, b2), id: 0 })`; the triangle holds e1 = p1 − p0 and e2 = p2 − p0.
    TriangleHit: triangle_hit(
        /// The ray.
        ray: Ray,
        /// The distances that count: min < t < max, in metres.
        within: Interval,
        /// The first corner, in metres.
        p0: Vec3,
        /// The second corner, in metres.
        p1: Vec3,
        /// The third corner, in metres.
        p2: Vec3,
    ) -> (
        /// Where the triangle is hit; none for a miss.
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

    /// Return the unit normal of the side from which p0, p1, p2 run counter-clockwise. A triangle without area has no
    /// answer.
    ///
    /// In Rust: `Dir3::new(v)` is the direction of a vector v of any length, and None where v has none.
    TriangleNormal: triangle_normal(
        /// The first corner, in metres.
        p0: Vec3,
        /// The second corner, in metres.
        p1: Vec3,
        /// The third corner, in metres.
        p2: Vec3,
    ) -> (
        /// The normal, of length 1; none for a triangle without area.
        normal: Option<Vec3>,
    ) {
        Triangle::new(p0, p1, p2).normal().map(|n| *n)
    }
}

row! {
    /// Where a triangle is hit.
    pub struct TriangleHitAnswer {
        /// The distance along the ray, in metres.
        pub t: f32,
        /// The weight of the second corner,
        pub b1: f32 [from 0 to 1],
        /// The weight of the third corner,
        pub b2: f32 [from 0 to 1],
    }
}
