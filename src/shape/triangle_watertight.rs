//! A triangle of a closed mesh, hit so that no ray slips through between it and its neighbours.

use crate::math::{interval::Interval, ray::Ray};
use crate::shape::Hit;
use glam::{Vec3, vec2};

// ANCHOR: hit_watertight
/// The same answer as [`Triangle::hit`](crate::shape::Shape::hit), but for rays within rounding errors of an edge:
/// of two triangles that share the edge exactly, one or both are hit, never neither (Woop, Benthin and Wald 2013).
///
/// The corners are moved so that the ray starts at 0, and sheared so that it runs along one axis. What is left is a
/// question in the plane: is 0 inside the triangle a, b, c? It is if the areas u = c × b, v = a × c and w = b × a,
/// of the triangles that 0 forms with the edges, have the same sign. Neighbours move a shared corner to the same place
/// and compute the same products for a shared edge, so they see 0 on the same side of it. A rounded difference of rounded
/// products never has the wrong sign, but it may be 0: then double precision, in which the products are exact, decides.
#[inline]
pub fn hit(corners: &[Vec3; 3], ray: &Ray, within: Interval) -> Option<Hit> {
    let shear = Shear::along(ray);
    let [p0, p1, p2] = *corners;
    let (a, b, c) = (
        shear.apply(p0 - ray.origin),
        shear.apply(p1 - ray.origin),
        shear.apply(p2 - ray.origin),
    );
    let (mut u, mut v, mut w) = (cross(c, b), cross(a, c), cross(b, a));
    if u == 0.0 || v == 0.0 || w == 0.0 {
        (u, v, w) = (cross_f64(c, b), cross_f64(a, c), cross_f64(b, a));
    }
    if u.min(v).min(w) < 0.0 && u.max(v).max(w) > 0.0 {
        return None;
    }
    // 0 if the triangle is seen from its edge, or has no area; t is then infinite or NaN and does not count.
    let inverse = 1.0 / (u + v + w);
    let t = (u * a.z + v * b.z + w * c.z) * inverse;
    within.contains(t).then_some(Hit {
        t,
        uv: vec2(v * inverse, w * inverse),
        id: 0,
    })
}
// ANCHOR_END: hit_watertight

/// The shear that turns a ray from 0 into a ray along +z, with t as z.
#[derive(Clone, Copy, Debug)]
pub struct Shear {
    /// The axes that become x, y and z; the last is the one along which the ray moves most.
    pub axes: [usize; 3],
    /// dₓ/d_z, d_y/d_z and 1/d_z.
    pub slopes: [f32; 3],
}

impl Shear {
    /// The shear of a ray.
    #[inline]
    pub fn along(ray: &Ray) -> Self {
        let d = ray.direction.to_array();
        let z = ray.direction.abs().max_position();
        let (x, y) = ((z + 1) % 3, (z + 2) % 3);
        let inverse = 1.0 / d[z];
        Self {
            axes: [x, y, z],
            slopes: [d[x] * inverse, d[y] * inverse, inverse],
        }
    }

    #[inline]
    fn apply(&self, p: Vec3) -> Vec3 {
        let p = p.to_array();
        let ([x, y, z], [sx, sy, sz]) = (self.axes, self.slopes);
        let (x, y, z) = (p[x], p[y], p[z]);
        Vec3::new(x - sx * z, y - sy * z, sz * z)
    }
}

/// The signed area of the parallelogram 0, p, p + q, q in the plane.
fn cross(p: Vec3, q: Vec3) -> f32 {
    p.x * q.y - p.y * q.x
}

/// The same, with exact products.
fn cross_f64(p: Vec3, q: Vec3) -> f32 {
    (f64::from(p.x) * f64::from(q.y) - f64::from(p.y) * f64::from(q.x)) as f32
}
