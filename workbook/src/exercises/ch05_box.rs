//! Chapter 5: `box_clip`, `bounds_of`.

use crate::exercise::exercises;
use crate::record::row;
use glam::Vec3;
use raybook::math::{aabb::Aabb, interval::Interval, ray::Ray, slab};

exercises! { ($) ch05_box
    /// Return the part of the interval on which the ray is inside the box; there is no answer if the ray never is. A
    /// ray that only touches the box, or runs in a face, counts as inside.
    BoxClip: box_clip(
        /// The ray.
        ray: Ray,
        /// The distances that count: min ≤ t ≤ max, in metres.
        within: Interval,
        /// The box's least corner, in metres.
        min: Vec3,
        /// The box's greatest corner, in metres.
        max: Vec3,
    ) -> (
        /// The distances at which the ray enters and leaves the box, in metres; none for a miss.
        inside: Option<Interval>,
    ) {
        slab::clip(&Aabb { min, max }, &ray, within)
    }

    /// Return the smallest axis-aligned box that holds all the points, by its least and its greatest corner. For no
    /// points, return the empty box: its least corner at +∞ and its greatest corner at −∞ along each axis.
    BoundsOf: bounds_of(
        /// The points, in metres.
        points: Vec<Vec3>,
    ) -> (
        /// The box.
        answer: Corners,
    ) {
        let Aabb { min, max } = Aabb::of(points.iter().copied());
        Corners { min, max }
    }
}

row! {
    /// Two opposite corners of a box.
    pub struct Corners {
        /// The least corner, in metres.
        pub min: Vec3,
        /// The greatest corner, in metres.
        pub max: Vec3,
    }
}
