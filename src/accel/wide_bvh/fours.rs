//! Eight boxes and eight triangles as two times four, by the vector instructions that every processor of a kind has: NEON of
//! 64-bit ARM, SSE2 of x86-64, and SIMD128 of WebAssembly where the program is compiled for it.
//!
//! There, glam's `Vec4` is one register, and its functions are one instruction each. So nothing here is `unsafe`.

use super::lanes::{Lanes, Struck, Work};
use super::node::{CHILDREN, Leaf, Link, Node};
use super::ray::WideRay;
use super::tree::Tree;
use crate::math::domain::{AREA_MAX, AREA_MIN};
use glam::Vec4;

/// What compiled programs may take for granted: vectors of four numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fours;

/// The first lanes of the two halves.
const HALVES: [usize; 2] = [0, 4];

impl Fours {
    /// What the instructions are called, where a vector of four numbers is one register.
    pub(super) const NAME: Option<&str> = if cfg!(target_arch = "aarch64") {
        Some("NEON")
    } else if cfg!(target_arch = "x86_64") {
        Some("SSE2")
    } else if cfg!(all(target_arch = "wasm32", target_feature = "simd128")) {
        Some("SIMD128")
    } else {
        None
    };

    /// Does the work.
    #[inline(never)]
    pub(super) fn run<W: Work>(self, work: W) -> W::Answer {
        work.with(self)
    }
}

/// Four of eight numbers, from one on.
#[inline(always)]
fn four(row: &[f32; 8], from: usize) -> Vec4 {
    Vec4::from_slice(&row[from..])
}

/// a·b + c, with one rounding where that is one instruction: a box test may round either way; see [`WideRay`].
#[inline(always)]
fn sum(a: Vec4, b: f32, c: f32) -> Vec4 {
    let (b, c) = (Vec4::splat(b), Vec4::splat(c));
    if cfg!(target_arch = "aarch64") {
        a.mul_add(b, c)
    } else {
        a * b + c
    }
}

/// Where the ray enters and where it leaves each of four boxes.
#[inline(always)]
fn slabs(node: &Node, ray: &WideRay, max: f32, from: usize) -> [Vec4; 2] {
    let (mut enter, mut leave) = (Vec4::splat(ray.min), Vec4::splat(max));
    for axis in 0..3 {
        let near = ray.near()[axis];
        let planes = |start: usize| four(&node.rows[start / CHILDREN], from);
        enter = enter.max(sum(planes(near), ray.inverse[axis], ray.enter[axis]));
        leave = leave.min(sum(
            planes(near ^ CHILDREN),
            ray.inverse[axis],
            ray.leave[axis],
        ));
    }
    [enter, leave]
}

/// Four triangles as they are hit: the bits and numbers of [`Struck`].
struct Met {
    mask: u32,
    unsure: u32,
    t: Vec4,
    b1: Vec4,
    b2: Vec4,
}

/// Four triangles, by the sums of [`hit`](crate::shape::triangle_watertight::hit); none if the ray passes by all of them.
#[inline(always)]
fn meet(leaf: &Leaf, ray: &WideRay, max: f32, from: usize) -> Option<Met> {
    let [ax, ay, az] = ray.shear.axes();
    let [sx, sy, sz] = ray.shear.slopes().map(Vec4::splat);
    let [ox, oy, oz] = ray.origin.map(Vec4::splat);
    let [a, b, c] = [0, 1, 2].map(|i| {
        let rows = |axis: usize| four(&leaf.corners[i][axis], from);
        let z = rows(az) - oz;
        [(rows(ax) - ox) - sx * z, (rows(ay) - oy) - sy * z, sz * z]
    });
    let cross = |p: [Vec4; 3], q: [Vec4; 3]| p[0] * q[1] - p[1] * q[0];
    let [u, v, w] = [cross(c, b), cross(a, c), cross(b, a)];
    let zero = Vec4::ZERO;
    let inside = u.min(v.min(w)).cmpge(zero) | u.max(v.max(w)).cmple(zero);
    if !inside.any() {
        return None;
    }
    let whole = u + v + w;
    let on_edge = u.cmpeq(zero) | v.cmpeq(zero) | w.cmpeq(zero);
    let extreme =
        whole.abs().cmplt(Vec4::splat(AREA_MIN)) | whole.abs().cmpgt(Vec4::splat(AREA_MAX));
    let unsure = inside & (on_edge | extreme);
    let inverse = Vec4::ONE / whole;
    let t = (u * a[2] + v * b[2] + w * c[2]) * inverse;
    let counts = Vec4::splat(ray.min).cmplt(t) & t.cmplt(Vec4::splat(max));
    Some(Met {
        mask: (inside & counts & !unsure).bitmask(),
        unsure: unsure.bitmask(),
        t,
        b1: v * inverse,
        b2: w * inverse,
    })
}

impl Lanes for Fours {
    #[inline(always)]
    fn boxes(self, node: &Node, ray: &WideRay, max: f32) -> (u32, [f32; CHILDREN]) {
        let (mut met, mut t) = (0, [0.0; CHILDREN]);
        for from in HALVES {
            let [enter, leave] = slabs(node, ray, max, from);
            met |= enter.cmple(leave).bitmask() << from;
            enter.write_to_slice(&mut t[from..]);
        }
        (met, t)
    }

    #[inline(always)]
    fn triangles(self, leaf: &Leaf, ray: &WideRay, max: f32) -> Option<Struck> {
        let mut struck = Struck::default();
        for from in HALVES {
            if let Some(met) = meet(leaf, ray, max, from) {
                struck.mask |= met.mask << from;
                struck.unsure |= met.unsure << from;
                met.t.write_to_slice(&mut struck.t[from..]);
                met.b1.write_to_slice(&mut struck.b1[from..]);
                met.b2.write_to_slice(&mut struck.b2[from..]);
            }
        }
        (struck.mask | struck.unsure != 0).then_some(struck)
    }

    #[inline(always)]
    fn fetch_next(self, _tree: &Tree, _link: Link) {}

    #[inline(always)]
    fn fetch_met(self, _tree: &Tree, _link: Link) {}
}
