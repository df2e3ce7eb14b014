//! A triangle of a closed mesh, hit so that no ray slips through between it and its neighbours.

use crate::math::{
    domain::{AREA_MAX, AREA_MIN},
    interval::Interval,
    ray::Ray,
};
use crate::shape::Hit;
use glam::{DVec3, Vec3, Vec3A, Vec3Swizzles, vec2};

/// The same answer as [`Triangle::hit`](crate::shape::Shape::hit), but for rays within rounding errors of an edge:
/// of two triangles that share the edge exactly, one or both are hit, never neither (Woop, Benthin and Wald 2013).
#[inline]
pub fn hit(corners: &[Vec3; 3], ray: &Ray, within: Interval) -> Option<Hit> {
    hit_sheared(corners, ray, &Shear::along(ray), within)
}

// ANCHOR: hit_watertight
/// The hit of a ray whose shear is known: all triangles that the ray is tested with share it.
///
/// The corners are moved so that the ray starts at 0, and sheared so that it runs along one axis. What is left is a
/// question in the plane: is 0 inside the triangle a, b, c? It is if the areas u = c × b, v = a × c and w = b × a,
/// of the triangles that 0 forms with the edges, have the same sign. Neighbours move a shared corner to the same place
/// and compute the same products for a shared edge, so they see 0 on the same side of it. A rounded difference of rounded
/// products never has the wrong sign, but it may be 0: then double precision, in which the products are exact, decides.
/// The vectors x, y and z hold these coordinates of a, b and c, so one operation does the same for all three.
/// Double precision also takes over where areas are so small or so large that areas · z vanishes or overflows.
#[inline]
pub(crate) fn hit_sheared(
    corners: &[Vec3; 3],
    ray: &Ray,
    shear: &Shear,
    within: Interval,
) -> Option<Hit> {
    let [x, y, z] = shear.apply(corners, ray.origin);
    let areas = x.zxy() * y.yzx() - y.zxy() * x.yzx(); // (u, v, w)
    if areas.cmplt(Vec3A::ZERO).any() && areas.cmpgt(Vec3A::ZERO).any() {
        return None;
    }
    let sum = areas.x + areas.y + areas.z;
    if areas.cmpeq(Vec3A::ZERO).any() || sum.abs() < AREA_MIN || sum.abs() > AREA_MAX {
        return hit_in_double([x, y, z], within);
    }
    let inverse = 1.0 / sum;
    let t = areas.dot(z) * inverse;
    within.contains(t).then_some(Hit {
        t,
        uv: vec2(areas.y * inverse, areas.z * inverse),
        id: 0,
    })
}
// ANCHOR_END: hit_watertight

/// The same sums, with areas in double precision; and where areas are extreme, in a unit of length as large as the numbers.
#[cold]
fn hit_in_double(corners: [Vec3A; 3], within: Interval) -> Option<Hit> {
    let [x, y, z] = corners.map(Vec3A::as_dvec3);
    let areas = x.zxy() * y.yzx() - y.zxy() * x.yzx();
    if areas.cmplt(DVec3::ZERO).any() && areas.cmpgt(DVec3::ZERO).any() {
        return None;
    }
    let usual = f64::from(AREA_MIN)..f64::from(AREA_MAX);
    let unit = if usual.contains(&areas.element_sum().abs()) {
        1.0
    } else {
        x.abs().max(y.abs()).max(z.abs()).max_element()
    };
    let (areas, z) = ((areas / (unit * unit)).as_vec3a(), (z / unit).as_vec3a());
    // 0 if the triangle is seen from its edge, or has no area; t is then infinite or NaN and does not count.
    let inverse = 1.0 / (areas.x + areas.y + areas.z);
    let t = areas.dot(z) * inverse * unit as f32;
    within.contains(t).then_some(Hit {
        t,
        uv: vec2(areas.y * inverse, areas.z * inverse),
        id: 0,
    })
}

/// The shear that turns a ray from 0 into a ray along +z, with t as z.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Shear {
    /// 0, 1 and 2 in some order. Only [`Shear::along`] writes it.
    axes: [usize; 3],
    slopes: [f32; 3],
}

impl Shear {
    /// The shear of a ray.
    #[inline]
    pub(crate) fn along(ray: &Ray) -> Self {
        /// By the axis that becomes z.
        const AXES: [[usize; 3]; 3] = [[1, 2, 0], [2, 0, 1], [0, 1, 2]];
        let Vec3 { x, y, z } = ray.direction.abs();
        // Sums of comparisons, not `if`: which axis it is cannot be guessed, and a wrong guess takes longer than the whole test.
        let x_is_less = usize::from(x < y) | usize::from(x < z);
        let axes = AXES[x_is_less * (1 + usize::from(y < z))];
        let d = ray.direction.to_array();
        // One by one: `axes.map` stays a call, and every ray through a mesh comes by here.
        let (dx, dy, dz) = (d[axes[0]], d[axes[1]], d[axes[2]]);
        let inverse = 1.0 / dz;
        Self {
            axes,
            slopes: [dx * inverse, dy * inverse, inverse],
        }
    }

    /// The axes that become x, y and z: 0, 1 and 2 in some order; the last is the one along which the ray moves most.
    #[inline]
    pub(crate) fn axes(&self) -> [usize; 3] {
        self.axes
    }

    /// dₓ/d_z, d_y/d_z and 1/d_z.
    #[inline]
    pub(crate) fn slopes(&self) -> [f32; 3] {
        self.slopes
    }

    /// The x, the y and the z of all three corners.
    #[inline]
    fn apply(&self, [a, b, c]: &[Vec3; 3], origin: Vec3) -> [Vec3A; 3] {
        let all = |i: usize| Vec3A::new(a[i], b[i], c[i]) - Vec3A::splat(origin[i]);
        let (x, y, z) = (all(self.axes[0]), all(self.axes[1]), all(self.axes[2]));
        let [sx, sy, sz] = self.slopes;
        [x - sx * z, y - sy * z, sz * z]
    }
}
