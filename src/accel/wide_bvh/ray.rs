//! A ray made ready for eight boxes at once.

use super::node::CHILDREN;
use crate::math::ray::Ray;
use crate::shape::triangle_watertight::Shear;
use glam::Vec3A;

/// The least |d| along an axis, so that 1/d is finite; over the widest scene, 4e9 m, it moves a ray by 4e-9 m.
const LEAST: f32 = 1e-18;

/// k: how many roundings a plane is moved away; see [`WideRay`].
const ROUNDINGS: f32 = 16.0;

/// What a ray's tests share.
///
/// A plane b is met at t = (b − o)/d. One fused operation per plane, b·(1/d) + (−o/d), is cheaper, but where b and o are
/// close it subtracts two large numbers, and its error is absolute: with u = 2⁻²⁴, the quotient 1/d is wrong by a factor
/// 1 ± u, o·(1/d) by 1 ± 2u, and each sum by u of itself, together at most 5u·(|b| + |o|)/|d|. So near planes are moved
/// towards the ray and far planes away from it by
///
/// pad = k·u·(largest |b| of the scene + |o|)/|d|,
///
/// once per ray, as part of −o/d: no box is missed by rounding, and it costs nothing per box. The test of a triangle moves
/// its corners by up to 8u·(|b| + |o|) too ([`triangle_watertight`](crate::shape::triangle_watertight)): k = 16 holds both.
#[derive(Clone, Copy, Debug)]
pub(super) struct WideRay {
    /// 1/d.
    pub(super) inverse: Vec3A,
    /// −o/d − pad, for planes through which the ray enters.
    pub(super) enter: Vec3A,
    /// −o/d + pad, for planes through which it leaves.
    pub(super) leave: Vec3A,
    /// 0 or 8; 16 or 24; 32 or 40: see [`WideRay::near`]. Only [`WideRay::new`] writes it.
    near: [usize; 3],
    /// What moves a triangle into the ray's frame.
    pub(super) shear: Shear,
    /// o along the shear's axes.
    pub(super) origin: [f32; 3],
    /// Nothing at or before this distance counts.
    pub(super) min: f32,
}

impl WideRay {
    /// Makes a ray ready for a scene whose coordinates are at most `largest`.
    #[inline(always)]
    pub(super) fn new(ray: &Ray, min: f32, largest: Vec3A) -> Self {
        let (o, d) = (Vec3A::from(ray.origin), Vec3A::from(*ray.direction));
        let inverse = d.abs().max(Vec3A::splat(LEAST)).copysign(d).recip();
        // Finite, whatever the origin: −o/d ± pad must not be ∞ − ∞. NaN becomes the least number here, and not by `max`: what
        // that makes of NaN differs between processors.
        let least = Vec3A::splat(f32::MIN);
        let finite = |v: Vec3A| {
            if v.is_finite() {
                return v; // as nearly always: it is not waited for
            }
            Vec3A::select(v.is_nan_mask(), least, v).clamp(least, Vec3A::MAX)
        };
        let middle = -o * inverse;
        let pad = (ROUNDINGS * 0.5 * f32::EPSILON) * (largest + o.abs()) * inverse.abs();
        let shear = Shear::along(ray);
        let backwards = d.is_negative_bitmask() as usize;
        let origin = ray.origin.to_array();
        let [x, y, z] = shear.axes();
        Self {
            inverse,
            enter: finite(middle - pad),
            leave: finite(middle + pad),
            near: [
                CHILDREN * (backwards & 1),
                CHILDREN * (2 + (backwards >> 1 & 1)),
                CHILDREN * (4 + (backwards >> 2 & 1)),
            ],
            origin: [origin[x], origin[y], origin[z]],
            shear,
            min,
        }
    }

    /// Per axis, where in a node's numbers the planes begin through which the ray enters: 0 or 8, 16 or 24, 32 or 40. Those
    /// through which it leaves begin at `near ^ 8`.
    #[inline(always)]
    pub(super) fn near(&self) -> [usize; 3] {
        self.near
    }
}
