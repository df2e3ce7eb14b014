//! Chapter 4: `plane_hit`.

use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::{Shape, plane::Plane};
use crate::exercise::{Asked, Exercise};
use crate::row::row;

/// This chapter's exercises, in order.
pub const EXERCISES: &[&dyn Asked] = &[&PlaneHit];

/// See [`Exercise::TASK`].
pub struct PlaneHit;

row! {
    /// A ray, the distances that count, and a plane.
    pub struct PlaneHitQuestion {
        /// The ray.
        pub ray: Ray,
        /// Only t with min < t < max counts.
        pub within: Interval,
        /// n: square to the plane.
        pub normal: Dir3,
        /// The plane holds all p with n·p = offset.
        pub offset: f32,
    }
}

impl Exercise for PlaneHit {
    type Question = PlaneHitQuestion;
    type Answer = Option<f32>;
    const NAME: &'static str = "plane_hit";
    const ANSWER: &'static str = "t";
    const TASK: &'static str = "Return the distance t in the interval (min < t < max) at which the ray meets the plane n·p = offset, as `Hit { t, uv: Vec2::ZERO, id: 0 }`, or None.";

    fn answer(q: &Self::Question) -> Self::Answer {
        Plane {
            normal: q.normal,
            offset: q.offset,
        }
        .hit(&q.ray, q.within)
        .map(|hit| hit.t)
    }
}
