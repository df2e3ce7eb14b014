//! Two boxes side by side, and a ray prepared for testing both at once.

use crate::accel::bvh::build::flat::Node;
use crate::math::{aabb::Aabb, interval::Interval, ray::Ray};
use glam::{Vec2, Vec3, Vec4, Vec4Swizzles, vec2, vec4};

/// The two children of a branch: two nodes of 32 bytes, in one cache line of 64.
///
/// Their coordinates are interleaved, because a processor computes with four neighbouring numbers at once (SIMD).
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(64))]
pub struct Pair {
    /// `[axis][end][side]`: the least coordinates of the left and the right box (`end` 0), and their greatest (`end` 1).
    planes: [[Vec2; 2]; 3],
    /// What is below the left and below the right node.
    pub links: [Link; 2],
}

/// What is below a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Link {
    /// For a branch, the number of its children's pair. For a leaf, the number of its first shape, in the order of the leaves.
    pub first: u32,
    /// The number of shapes of a leaf; 0 for a branch.
    pub count: u32,
}

impl Link {
    /// A placeholder for a link.
    pub const NONE: Self = Self { first: 0, count: 0 };
}

impl Pair {
    /// The pair of a left and a right node.
    pub fn new([left, right]: [Node; 2]) -> Self {
        let (l, r) = (&left.bounds, &right.bounds);
        let planes = |axis| {
            [
                vec2(l.min[axis], r.min[axis]),
                vec2(l.max[axis], r.max[axis]),
            ]
        };
        Self {
            planes: [planes(0), planes(1), planes(2)],
            links: [left.link, right.link],
        }
    }

    /// The two nodes.
    pub fn nodes(&self) -> [Node; 2] {
        [0, 1].map(|side| {
            let corner = |end: usize| Vec3::from_array(self.planes.map(|ends| ends[end][side]));
            let (min, max) = (corner(0), corner(1));
            Node {
                bounds: Aabb { min, max },
                link: self.links[side],
            }
        })
    }
}

/// A ray, with the numbers that its tests of all pairs share.
///
/// The test is that of [`RayBox`](crate::accel::ray_box::RayBox), but for four planes at a time: the two near and the two far
/// planes of an axis. The distances to the far planes are negated, so that one maximum finds the last near plane and the first
/// far plane.
///
/// No box is missed by rounding: near planes are moved towards the ray's origin, and far planes away from it, by
///
/// step = k·u·(largest |b| of the scene + |o|), u = 2⁻²⁴.
#[derive(Clone, Copy, Debug)]
pub struct RayPair {
    /// Per axis, whether the ray meets the greatest coordinates first.
    falls: [bool; 3],
    /// The ray's origin, moved a step forwards for the near planes, and a step backwards for the far planes.
    origin: [Vec4; 3],
    /// 1/d for the near planes, −1/d for the far planes.
    inverse: [Vec4; 3],
    /// The interval's `min` for the near planes, and minus its `max` for the far planes.
    within: Vec4,
}

/// k. A distance (b − o)·(1/d) has three roundings, each of u of the result (Ize, "Robust BVH ray traversal", 2013), so the
/// plane seems moved by up to 3u·(|b| + |o|). A triangle's test moves the corners by up to 8u·(|b| + |o|), and its distance has
/// an error of the same size: a ray that starts so close behind a wall may still hit the wall, at a distance just above 0.
/// k = 16 covers the sum.
const ROUNDINGS: f32 = 16.0;

impl RayPair {
    /// Prepares a ray for the boxes inside the box `all`.
    #[inline]
    pub fn new(ray: &Ray, within: Interval, all: &Aabb) -> Self {
        let (o, d) = (ray.origin, *ray.direction);
        // A ray that runs in a face of a box is moved off the plane, to the side of the box, so 0·∞ does not happen there. Just
        // beside the box, the move may put the ray into the plane: then `max` drops the NaN, and the box is opened in vain.
        let sizes = o.abs() + all.min.abs().max(all.max.abs());
        let step = (ROUNDINGS * 0.5 * f32::EPSILON * sizes + f32::MIN_POSITIVE).copysign(d);
        let (near, far, inverse) = (o + step, o - step, d.recip());
        let both = |near: f32, far: f32| vec4(near, near, far, far);
        Self {
            // The sign bit, not d < 0: −0.0 is the mirror image of +0.0.
            falls: d.to_array().map(f32::is_sign_negative),
            origin: [
                both(near.x, far.x),
                both(near.y, far.y),
                both(near.z, far.z),
            ],
            inverse: [
                both(inverse.x, -inverse.x),
                both(inverse.y, -inverse.y),
                both(inverse.z, -inverse.z),
            ],
            within: both(within.min, -within.max),
        }
    }

    /// Ends the interval at distance t.
    #[inline]
    pub fn shorten(&mut self, t: f32) {
        self.within = vec4(self.within.x, self.within.y, -t, -t);
    }

    /// The distances, up to rounding, at which the ray enters the left and the right box, or where the interval begins if that is
    /// later; `None` for a box that the ray certainly does not meet within the interval.
    #[inline]
    pub fn enters(&self, pair: &Pair) -> [Option<f32>; 2] {
        let t = |axis: usize| {
            let falls = usize::from(self.falls[axis]);
            let (near, far) = (pair.planes[axis][falls], pair.planes[axis][1 - falls]);
            (vec4(near.x, near.y, far.x, far.y) - self.origin[axis]) * self.inverse[axis]
        };
        let enter = t(0).max(t(1)).max(t(2)).max(self.within);
        let leave = -enter.zwxy();
        let meets = enter.cmple(leave).bitmask();
        [
            (meets & 1 != 0).then_some(enter.x),
            (meets & 2 != 0).then_some(enter.y),
        ]
    }
}
