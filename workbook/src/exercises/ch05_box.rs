//! Chapter 5: `box_clip`, `bounds_of`.

use raybook::math::{aabb::Aabb, interval::Interval, ray::Ray, slab};
use crate::exercise::exercises;
use crate::record::row;
use glam::Vec3;

exercises! { ($) ch05_box
    /// Return the part of the interval on which the ray is inside the box, as an Interval, or None if it never is; a
    /// ray in a face touches the box.
    BoxClip: box_clip(
        /// The ray.
        ray: Ray,
        /// Only this stretch of the ray counts.
        within: Interval,
        /// The box's least corner.
        min: Vec3,
        /// The box's greatest corner.
        max: Vec3,
    ) -> (
        /// Inside.
        inside: Option<Interval>,
    ) {
        slab::clip(
            &Aabb {
                min,
                max,
            },
            &ray,
            within,
        )
    }

    /// Return the smallest box that holds all the points: its least and its greatest corner.
    BoundsOf: bounds_of(
        /// The points.
        points: Vec<Vec3>,
    ) -> (
        /// Answer.
        answer: Corners,
    ) {
        let Aabb { min, max } = Aabb::of(points.iter().copied());
        Corners { min, max }
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
