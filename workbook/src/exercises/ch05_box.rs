//! Chapter 5: `box_clip`, `bounds_of`.

use raybook::math::{aabb::Aabb, interval::Interval, ray::Ray, slab};
use crate::exercise::{Asked, Exercise};
use crate::row::row;
use glam::Vec3;

/// This chapter's exercises, in order.
pub const EXERCISES: &[&dyn Asked] = &[&BoxClip, &BoundsOf];

/// See [`Exercise::TASK`].
pub struct BoxClip;

row! {
    /// A ray, the distances that count, and a box.
    pub struct BoxClipQuestion {
        /// The ray.
        pub ray: Ray,
        /// Only this stretch of the ray counts.
        pub within: Interval,
        /// The box's least corner.
        pub min: Vec3,
        /// The box's greatest corner.
        pub max: Vec3,
    }
}

impl Exercise for BoxClip {
    type Question = BoxClipQuestion;
    type Answer = Option<Interval>;
    const NAME: &'static str = "box_clip";
    const ANSWER: &'static str = "inside";
    const TASK: &'static str = "Return the part of the interval on which the ray is inside the box, as an Interval, or None if it never is; a ray in a face touches the box.";

    fn answer(q: &Self::Question) -> Self::Answer {
        slab::clip(
            &Aabb {
                min: q.min,
                max: q.max,
            },
            &q.ray,
            q.within,
        )
    }
}

/// See [`Exercise::TASK`].
pub struct BoundsOf;

row! {
    /// Some points.
    pub struct BoundsOfQuestion {
        /// The points.
        pub points: Vec<Vec3>,
    }
}

row! {
    /// Two opposite corners of a box.
    pub struct Corners {
        /// The least corner.
        pub min: Vec3,
        /// The greatest corner.
        pub max: Vec3,
    }
}

impl Exercise for BoundsOf {
    type Question = BoundsOfQuestion;
    type Answer = Corners;
    const NAME: &'static str = "bounds_of";
    const TASK: &'static str =
        "Return the smallest box that holds all the points: its least and its greatest corner.";

    fn answer(q: &Self::Question) -> Self::Answer {
        let Aabb { min, max } = Aabb::of(q.points.iter().copied());
        Corners { min, max }
    }
}
