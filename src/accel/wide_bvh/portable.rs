//! Eight boxes and eight triangles at once, by plain arithmetic on arrays, on any processor.

use super::lanes::{Lanes, Struck, Work};
use super::node::{CHILDREN, Leaf, Link, Node, TRIANGLES};
use super::ray::WideRay;
use super::tree::Tree;
use crate::math::domain::{AREA_MAX, AREA_MIN};

/// What every processor can do.
///
/// The compiler makes vector instructions of these loops where it may; the answers are those of any other [`Lanes`], bit for
/// bit, for a box test only decides how far a search looks, and a triangle's test is the same sum, step by step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Portable;

impl Portable {
    /// Does the work.
    #[inline(never)]
    pub(super) fn run<W: Work>(self, work: W) -> W::Answer {
        work.with(self)
    }
}

impl Lanes for Portable {
    #[inline(always)]
    fn boxes(self, node: &Node, ray: &WideRay, max: f32) -> (u32, [f32; CHILDREN]) {
        let mut enter = [ray.min; CHILDREN];
        let mut leave = [max; CHILDREN];
        let rows = |start: usize| &node.rows[start / CHILDREN];
        for axis in 0..3 {
            let (near, far) = (rows(ray.near()[axis]), rows(ray.near()[axis] ^ CHILDREN));
            for lane in 0..CHILDREN {
                enter[lane] = enter[lane].max(near[lane] * ray.inverse[axis] + ray.enter[axis]);
                leave[lane] = leave[lane].min(far[lane] * ray.inverse[axis] + ray.leave[axis]);
            }
        }
        let met = (0..CHILDREN).map(|lane| u32::from(enter[lane] <= leave[lane]) << lane);
        (met.sum(), enter)
    }

    #[inline(always)]
    fn triangles(self, leaf: &Leaf, ray: &WideRay, max: f32) -> Option<Struck> {
        let mut struck = Struck::default();
        for lane in 0..TRIANGLES {
            let corner = |i: usize| {
                let rows = &leaf.corners[i];
                let along = |axis: usize| rows[ray.shear.axes()[axis]][lane] - ray.origin[axis];
                let [sx, sy, sz] = ray.shear.slopes();
                let z = along(2);
                [along(0) - sx * z, along(1) - sy * z, sz * z]
            };
            let cross = |p: [f32; 3], q: [f32; 3]| p[0] * q[1] - p[1] * q[0];
            let (a, b, c) = (corner(0), corner(1), corner(2));
            let (u, v, w) = (cross(c, b), cross(a, c), cross(b, a));
            if u.min(v).min(w) < 0.0 && u.max(v).max(w) > 0.0 {
                continue;
            }
            let sum = u + v + w;
            let extreme = sum.abs() < AREA_MIN || sum.abs() > AREA_MAX;
            if u == 0.0 || v == 0.0 || w == 0.0 || extreme {
                struck.unsure |= 1 << lane;
                continue;
            }
            let inverse = 1.0 / sum;
            let t = (u * a[2] + v * b[2] + w * c[2]) * inverse;
            if ray.min < t && t < max {
                struck.mask |= 1 << lane;
                struck.t[lane] = t;
                struck.b1[lane] = v * inverse;
                struck.b2[lane] = w * inverse;
            }
        }
        (struck.mask | struck.unsure != 0).then_some(struck)
    }

    #[inline(always)]
    fn fetch_next(self, _tree: &Tree, _link: Link) {}

    #[inline(always)]
    fn fetch_met(self, _tree: &Tree, _link: Link) {}
}
