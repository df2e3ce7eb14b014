//! A ray made ready to be tested against many boxes.

use crate::math::{aabb::Aabb, interval::Interval, ray::Ray};
use glam::Vec3;

/// A ray with what its box tests share.
///
/// [`slab::clip`](crate::math::slab::clip) gives an interval, rounded like any result; a search of a tree needs only a
/// yes or no, but it must never be a wrong no: a box that is missed by a rounding error takes its shapes with it.
#[derive(Clone, Copy, Debug)]
pub struct RayBox {
    origin: Vec3,
    /// 1/d per axis; ±∞ where the ray does not move.
    inverse: Vec3,
    /// Per axis, which of (min, max) the ray meets first: 0 or 1.
    near: [usize; 3],
}

/// How much later a box is left than was computed, as a part of the distance.
///
/// A quotient (b − o)·(1/d) has three roundings, each of 2⁻²⁴ of the result, so the two that are compared are together
/// wrong by less than 2·γ₃, γ₃ = 3·2⁻²⁴/(1 − 3·2⁻²⁴): 6 roundings (Ize 2013). A triangle's own test sees its corners up to 5
/// roundings off (in p − o, two in the slope of the ray, in their product and in the last difference), so it may be hit
/// where, rightly, the ray passes its box by. That makes 11; 16 leave some to spare.
const SLACK: f32 = 16.0 * (f32::EPSILON / 2.0);

impl RayBox {
    /// Makes a ray ready.
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

    /// Where the ray enters the box, at the latest, or where the interval begins if that is later; `None` if it certainly
    /// does not meet the box within the interval.
    ///
    /// The box must be finite. An interval may be empty or inverted: then there is nothing to meet.
    pub fn enters(&self, bounds: &Aabb, within: Interval) -> Option<f32> {
        let planes = [bounds.min, bounds.max];
        let (mut min, mut max) = (within.min, within.max);
        for axis in 0..3 {
            let near = planes[self.near[axis]][axis];
            let far = planes[1 - self.near[axis]][axis];
            let near = (near - self.origin[axis]) * self.inverse[axis];
            let far = (far - self.origin[axis]) * self.inverse[axis];
            // −∞, where a ray runs parallel to the box and beside it, stays −∞.
            let far = far + far.abs().min(f32::MAX) * SLACK;
            // 0·∞: the ray runs in this face. The comparisons are false for the NaN, and the other face decides.
            min = if near > min { near } else { min };
            max = if far < max { far } else { max };
        }
        (min <= max).then_some(min)
    }
}
