//! A ray clipped by a box: the interval of distances in which the ray is inside the box.
//!
//! ```
//! use raybook::math::slab;
//! use raybook::prelude::*;
//!
//! let cube = Aabb::new(Vec3::ZERO, vec3(1.0, 1.0, 1.0));
//! let ray = |y| Ray::new(vec3(-2.0, y, 0.5), Dir3::X);
//! let inside = slab::clip(&cube, &ray(0.5), Interval::AHEAD);
//! assert_eq!(inside, Some(Interval::new(2.0, 3.0)));
//! assert_eq!(slab::clip(&cube, &ray(1.5), Interval::AHEAD), None); // passes above it
//! ```

use crate::math::{aabb::Aabb, interval::Interval, ray::Ray};

// ANCHOR: box_clip
/// The part of `within` in which the ray is inside the box; `None` if it is never inside.
///
/// A box is three slabs. Along axis i the ray is inside the slab from t = (nearᵢ − oᵢ)/dᵢ to t = (farᵢ − oᵢ)/dᵢ,
/// where near and far are the slab's two planes in the order in which the ray meets them.
/// The ray is inside the box where the three intervals and `within` overlap (Kay and Kajiya 1986).
///
/// A ray in a face, along an edge or through a corner touches the box; then the interval may be a single distance.
/// If the ray does not move along an axis, it is inside the slab from −∞ to ∞, or never: division by 0 gives this result.
pub fn clip(bounds: &Aabb, ray: &Ray, within: Interval) -> Option<Interval> {
    let Interval { mut min, mut max } = within;
    for axis in 0..3 {
        let (o, d) = (ray.origin[axis], ray.direction[axis]);
        let (mut near, mut far) = (bounds.min[axis], bounds.max[axis]);
        // The sign bit, not d < 0: it makes −0.0 the mirror image of +0.0.
        if d.is_sign_negative() {
            std::mem::swap(&mut near, &mut far);
        }
        // 0/0: the ray runs in this face. `max` and `min` drop the NaN, and the other face decides.
        min = min.max((near - o) / d);
        max = max.min((far - o) / d);
    }
    // Not min <= max: for a ray beside an infinite box, both may be ∞, or both −∞; then their difference is NaN.
    (max - min >= 0.0).then_some(Interval { min, max })
}
// ANCHOR_END: box_clip
