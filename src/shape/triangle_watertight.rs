//! The watertight hit of a triangle: no ray slips through between the triangles of a closed mesh.
//!
//! ```
//! use raybook::prelude::*;
//! use raybook::shape::triangle_watertight;
//!
//! // Two triangles share an edge. A ray through the edge hits at least one of them.
//! let [a, b, c, d] = [Vec3::ZERO, vec3(1.0, 1.0, 0.0), Vec3::Y, Vec3::X];
//! let ray = Ray::new(vec3(0.3, 0.3, 1.0), -Dir3::Z);
//! let hit = |corners| triangle_watertight::hit(&corners, &ray, Interval::AHEAD).is_some();
//! assert!(hit([a, b, c]) || hit([a, d, b]));
//! ```

use crate::math::{
    domain::{AREA_MAX, AREA_MIN},
    interval::Interval,
    ray::Ray,
};
use crate::shape::Hit;
use glam::{DVec3, Vec3, Vec3A, Vec3Swizzles, vec2};

/// The same answer as [`Triangle::hit`](crate::shape::Shape::hit), except for rays within rounding errors of an edge: if two
/// triangles share the edge exactly, at least one of them is hit (Woop, Benthin and Wald, "Watertight ray/triangle intersection",
/// 2013).
#[inline]
pub fn hit(corners: &[Vec3; 3], ray: &Ray, within: Interval) -> Option<Hit> {
    hit_sheared(corners, ray, &Shear::along(ray), within)
}

// ANCHOR: hit_watertight
/// The watertight hit of a ray whose shear is known; all triangles that are tested against the ray share the shear.
///
/// The corners are moved so that the ray starts at 0, and sheared so that the ray runs along one axis. What is left is a
/// question in the plane: is 0 inside the triangle a, b, c? The answer is yes if u = c × b, v = a × c and w = b × a have the same
/// sign. These are twice the areas of the triangles between 0 and the edges. Neighbours move a shared corner to the same place
/// and compute the same products for a shared edge, so for both, 0 is on the same side of the edge. A rounded difference of
/// rounded products never has the wrong sign, but it may be 0: then double precision, in which the products are exact, decides.
/// The vectors x, y and z hold these coordinates of a, b and c, so that one operation computes with all three corners.
/// Double precision is also used if the areas are very small or very large, because then areas · z would vanish or overflow.
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

/// As [`hit_sheared`], but with areas in double precision, and if areas are extreme, in a unit of length that suits the numbers.
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
    // The sum is 0 if the triangle is seen from its edge, or has no area. Then t is infinite or NaN, and is no hit.
    let inverse = 1.0 / (areas.x + areas.y + areas.z);
    let t = areas.dot(z) * inverse * unit as f32;
    within.contains(t).then_some(Hit {
        t,
        uv: vec2(areas.y * inverse, areas.z * inverse),
        id: 0,
    })
}

/// The shear that maps a ray from 0 to a ray along +z, such that z is the distance t.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Shear {
    /// 0, 1 and 2 in some order. Only [`Shear::along`] writes it.
    axes: [usize; 3],
    slopes: [f32; 3],
}

impl Shear {
    /// The axes that become x, y and z, by the axis that becomes z.
    const AXES: [[usize; 3]; 3] = [[1, 2, 0], [2, 0, 1], [0, 1, 2]];

    /// The shear of a ray.
    #[inline]
    pub(crate) fn along(ray: &Ray) -> Self {
        let Vec3 { x, y, z } = ray.direction.abs();
        // Sums of comparisons, not `if`: a processor cannot predict the axis, and a wrong prediction costs more than the whole
        // test.
        let x_is_less = usize::from(x < y) | usize::from(x < z);
        let axes = Self::AXES[x_is_less * (1 + usize::from(y < z))];
        let d = ray.direction.to_array();
        // One by one: `axes.map` remains a function call, and this code runs for every ray through a mesh.
        let (dx, dy, dz) = (d[axes[0]], d[axes[1]], d[axes[2]]);
        let inverse = 1.0 / dz;
        Self {
            axes,
            slopes: [dx * inverse, dy * inverse, inverse],
        }
    }

    /// The axes that become x, y and z: 0, 1 and 2 in some order. The last one is the axis along which the ray moves most.
    #[inline]
    pub(crate) fn axes(&self) -> [usize; 3] {
        self.axes
    }

    /// dₓ/d_z, d_y/d_z and 1/d_z.
    #[inline]
    pub(crate) fn slopes(&self) -> [f32; 3] {
        self.slopes
    }

    /// The x coordinates of the three moved and sheared corners, their y coordinates and their z coordinates.
    #[inline]
    fn apply(&self, [a, b, c]: &[Vec3; 3], origin: Vec3) -> [Vec3A; 3] {
        let all = |i: usize| Vec3A::new(a[i], b[i], c[i]) - Vec3A::splat(origin[i]);
        let by = |[x, y, z]: [usize; 3]| (all(x), all(y), all(z));
        // One branch, the same for all triangles of a ray; where `axes` were asked, each of nine coordinates would be looked up.
        let (x, y, z) = match self.axes[2] {
            0 => by(Self::AXES[0]),
            1 => by(Self::AXES[1]),
            _ => by(Self::AXES[2]),
        };
        let [sx, sy, sz] = self.slopes;
        [x - sx * z, y - sy * z, sz * z]
    }
}
