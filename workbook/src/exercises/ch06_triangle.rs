//! Chapter 6: `triangle_hit`, `triangle_normal`.

use raybook::math::{interval::Interval, ray::Ray};
use raybook::shape::{Shape, triangle::Triangle};
use crate::exercise::{Asked, Exercise};
use crate::row::row;
use glam::Vec3;

/// This chapter's exercises, in order.
pub const EXERCISES: &[&dyn Asked] = &[&TriangleHit, &TriangleNormal];

/// See [`Exercise::TASK`].
pub struct TriangleHit;

row! {
    /// A ray, the distances that count, and a triangle.
    pub struct TriangleHitQuestion {
        /// The ray.
        pub ray: Ray,
        /// Only t with min < t < max counts.
        pub within: Interval,
        /// The first corner.
        pub p0: Vec3,
        /// The second corner.
        pub p1: Vec3,
        /// The third corner.
        pub p2: Vec3,
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

impl Exercise for TriangleHit {
    type Question = TriangleHitQuestion;
    type Answer = Option<TriangleHitAnswer>;
    const NAME: &'static str = "triangle_hit";
    const TASK: &'static str = "Return where the ray meets the triangle with min < t < max, from either side, as `Hit { t, uv: (b1, b2), id: 0 }`, or None; the point is p0 + b1·e1 + b2·e2.";

    fn answer(q: &Self::Question) -> Self::Answer {
        Triangle::new(q.p0, q.p1, q.p2)
            .hit(&q.ray, q.within)
            .map(|hit| TriangleHitAnswer {
                t: hit.t,
                b1: hit.uv.x,
                b2: hit.uv.y,
            })
    }
}

/// See [`Exercise::TASK`].
pub struct TriangleNormal;

row! {
    /// The corners of a triangle.
    pub struct TriangleQuestion {
        /// The first corner.
        pub p0: Vec3,
        /// The second corner.
        pub p1: Vec3,
        /// The third corner.
        pub p2: Vec3,
    }
}

impl Exercise for TriangleNormal {
    type Question = TriangleQuestion;
    type Answer = Option<Vec3>;
    const NAME: &'static str = "triangle_normal";
    const ANSWER: &'static str = "normal";
    const TASK: &'static str = "Return the unit normal of the side from which p0, p1, p2 run counter-clockwise, or None for a triangle without area.";

    fn answer(q: &Self::Question) -> Self::Answer {
        Triangle::new(q.p0, q.p1, q.p2).normal().map(|n| *n)
    }
}
