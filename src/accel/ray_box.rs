//! A ray, prepared for tests against many boxes.

use crate::math::{aabb::Aabb, interval::Interval, ray::Ray};
use glam::Vec3;

/// A ray, with the numbers that its tests of all boxes share.
///
/// [`slab::clip`](crate::math::slab::clip) returns an interval, rounded like any result. A search of a tree needs only a yes or
/// a no, but the no must never be wrong: with a box that is missed by a rounding error, all shapes in the box are missed.
#[derive(Clone, Copy, Debug)]
pub struct RayBox {
    origin: Vec3,
    /// 1/d per axis; ±∞ where the ray does not move.
    inverse: Vec3,
    /// Per axis, which of (min, max) the ray meets first: 0 or 1.
    near: [usize; 3],
}

/// How much later than computed a ray leaves a box, as a part of the distance.
///
/// A distance (b − o)·(1/d) has three roundings, each of 2⁻²⁴ of the result. So the two distances that are compared have
/// together an error below 2·γ₃, γ₃ = 3·2⁻²⁴/(1 − 3·2⁻²⁴): 6 roundings (Ize, "Robust BVH ray traversal", 2013). A triangle's test
/// moves the corners by up to 5 roundings (one in p − o, two in the slope of the ray, one in their product and one in the last
/// difference), so it may report a hit although the exact ray misses the box. Together these are 11; 16 leave a margin.
const SLACK: f32 = 16.0 * (f32::EPSILON / 2.0);

impl RayBox {
    /// Prepares a ray.
    #[inline]
    pub fn new(ray: &Ray) -> Self {
        let direction = *ray.direction;
        Self {
            origin: ray.origin,
            inverse: direction.recip(),
            // The sign bit, not d < 0: it makes −0.0 the mirror image of +0.0.
            near: direction
                .to_array()
                .map(|d| usize::from(d.is_sign_negative())),
        }
    }

    /// The distance, up to rounding, at which the ray enters the box, or where the interval begins if that is later; `None` if
    /// the ray certainly does not meet the box within the interval.
    ///
    /// The box must be finite. The interval may be empty or inverted: then the answer is `None`.
    #[inline]
    pub fn enters(&self, bounds: &Aabb, within: Interval) -> Option<f32> {
        let planes = [bounds.min, bounds.max];
        let (mut min, mut max) = (within.min, within.max);
        for axis in 0..3 {
            let near = planes[self.near[axis]][axis];
            let far = planes[1 - self.near[axis]][axis];
            let near = (near - self.origin[axis]) * self.inverse[axis];
            let far = (far - self.origin[axis]) * self.inverse[axis];
            // −∞ stays −∞: a ray beside the box, parallel to its faces.
            let far = far + far.abs().min(f32::MAX) * SLACK;
            // 0·∞: the ray runs in this face. Comparisons with the NaN are false, so the other face decides.
            min = if near > min { near } else { min };
            max = if far < max { far } else { max };
        }
        (min <= max).then_some(min)
    }
}
