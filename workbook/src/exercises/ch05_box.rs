//! Chapter 5: `box_clip`, `bounds_of`.

use crate::exercise::exercises;
use crate::record::row;
use glam::Vec3;
use raybook::math::{aabb::Aabb, interval::Interval, ray::Ray, slab};

exercises! { ($) ch05_box
    /// Return the part of the interval on which the ray is inside the box, from where it enters to where it leaves, or
    /// none if it never is; a ray in a face touches the box.
    BoxClip: box_clip(
        /// The ray.
        ray: Ray,
        /// The distances that count, in metres.
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

    /// Return the smallest box that holds all the points: its least and its greatest corner.
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
