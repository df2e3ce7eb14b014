//! A ray clipped by a box: the interval of distances on which it is inside.

use crate::math::{aabb::Aabb, interval::Interval, ray::Ray};

// ANCHOR: box_clip
/// The part of `within` on which the ray is inside the box, or `None` if it never is.
///
/// A box is three slabs. Along axis i the ray is inside the slab from t = (nearᵢ − oᵢ)/dᵢ to t = (farᵢ − oᵢ)/dᵢ,
/// where near and far are the slab's two planes in the order in which the ray meets them.
/// The box is where the three intervals and `within` overlap (Kay and Kajiya 1986).
///
/// A ray in a face, along an edge or through a corner touches the box; there the interval may be a single distance.
/// Along an axis in which the ray does not move, it is inside from −∞ to ∞, or never: division by 0 says so by itself.
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
    // Not min <= max: along a box without end, but beside it, both are ∞, or both −∞; their difference is NaN.
    (max - min >= 0.0).then_some(Interval { min, max })
}
// ANCHOR_END: box_clip
