//! Two boxes side by side, and a ray made ready to be tested against both at once.

use crate::accel::bvh::build::flat::Node;
use crate::math::{aabb::Aabb, interval::Interval, ray::Ray};
use glam::{Vec2, Vec3, Vec4, vec2, vec4};

/// The two children of a branch: 64 bytes, one cache line.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(64))]
pub struct Pair {
    /// Per axis, the least and the greatest coordinate of (left, right).
    planes: [[Vec2; 2]; 3],
    /// Of the left and the right one.
    pub links: [Link; 2],
}

/// What is below a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Link {
    /// Of a branch: which pair its children are. Of a leaf: its first shape, in the order of the leaves.
    pub first: u32,
    /// How many shapes a leaf has; 0 for a branch.
    pub count: u32,
}

impl Pair {
    /// The pair of two nodes.
    pub fn new([left, right]: [Node; 2]) -> Self {
        let planes = |axis| {
            [
                vec2(left.bounds.min[axis], right.bounds.min[axis]),
                vec2(left.bounds.max[axis], right.bounds.max[axis]),
            ]
        };
        Self {
            planes: [planes(0), planes(1), planes(2)],
            links: [left, right].map(|node| Link {
                first: node.first,
                count: node.count,
            }),
        }
    }

    /// The left node, 0, or the right one, 1.
    pub fn node(&self, side: usize) -> Node {
        let corner = |end: usize| Vec3::from_array(self.planes.map(|ends| ends[end][side]));
        let Link { first, count } = self.links[side];
        Node {
            bounds: Aabb {
                min: corner(0),
                max: corner(1),
            },
            first,
            count,
        }
    }
}

/// A ray with what its tests of pairs share: a test of four planes at a time, the near and far ones of both boxes.
#[derive(Clone, Copy, Debug)]
pub struct RayPair {
    /// Per axis, which of (min, max) the ray meets first: 0 or 1.
    near: [usize; 3],
    /// The ray's origin, a little further on for the near planes, and a little back for the far ones.
    origin: [Vec4; 3],
    /// 1/d for the near planes, −1/d for the far ones.
    inverse: [Vec4; 3],
}

const SLACK: f32 = 8.0 * (f32::EPSILON / 2.0);

impl RayPair {
    /// Makes a ray ready.
    #[inline]
    pub fn new(ray: &Ray) -> Self {
        let (d, o) = (ray.direction.to_array(), ray.origin.to_array());
        let both = |near: f32, far: f32| vec4(near, near, far, far);
        let near = d.map(|d| usize::from(d.is_sign_negative()));
        let axes = [0, 1, 2];
        Self {
            near,
            origin: axes.map(|i| {
                let (up, down) = (o[i].next_up(), o[i].next_down());
                if near[i] == 0 {
                    both(up, down)
                } else {
                    both(down, up)
                }
            }),
            inverse: axes.map(|i| both(1.0 / d[i], -1.0 / d[i])),
        }
    }

    /// (enter left, enter right, −leave left, −leave right), all clipped by `limits`.
    #[inline]
    pub fn enters(&self, pair: &Pair, limits: Vec4) -> Vec4 {
        let t = |i: usize| {
            let near = pair.planes[i][self.near[i]];
            let far = pair.planes[i][1 - self.near[i]];
            (vec4(near.x, near.y, far.x, far.y) - self.origin[i]) * self.inverse[i]
        };
        let t = t(0).max(t(1)).max(t(2));
        // Not ∞ − ∞: a NaN would be taken for a hit, and a ray along an axis would visit every box.
        (t - t.abs().min(Vec4::MAX) * SLACK).max(limits)
    }
}

/// x
#[inline]
pub fn limits(within: Interval) -> Vec4 {
    vec4(within.min, within.min, -within.max, -within.max)
}
