//! The infinite plane.
//!
//! ```
//! use raybook::prelude::*;
//!
//! let floor = Plane::through(Vec3::ZERO, Dir3::Y);
//! let steep = Dir3::new(vec3(3.0, -4.0, 0.0)).expect("longer than 0");
//! let hit = floor.hit(&Ray::new(vec3(0.0, 4.0, 0.0), steep), Interval::AHEAD);
//! assert!((hit.expect("below").t - 5.0).abs() < 1e-5); // 4 m down, 3 m to the side
//! ```

use crate::math::{aabb::Aabb, basis::Basis, dir3::Dir3, interval::Interval, ray::Ray};
use crate::shape::{Hit, ROUNDING, Shape, Surface};
use glam::{Vec2, Vec3, vec2};

/// All points p with n·p = c. The outside is the side to which n points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// n: the normal, which points to the outside.
    pub normal: Dir3,
    /// c: the distance from the world's origin along n, in metres.
    pub offset: f32,
}

impl Plane {
    /// The plane through a point, in metres, perpendicular to `normal`.
    pub fn through(point: Vec3, normal: Dir3) -> Self {
        Self {
            normal,
            offset: normal.dot(point),
        }
    }
}

impl Shape for Plane {
    fn bounds(&self) -> Aabb {
        Aabb::EVERYTHING
    }

    // ANCHOR: plane_hit
    /// Solves n·(o + t·d) = c for t: t = (c − n·o)/(n·d).
    ///
    /// For a ray parallel to the plane, n·d = 0: t is infinite or, in the plane itself, NaN. Neither is in the interval.
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let t = (self.offset - self.normal.dot(ray.origin)) / self.normal.dot(*ray.direction);
        within.contains(t).then_some(Hit {
            t,
            uv: Vec2::ZERO,
            id: 0,
        })
    }
    // ANCHOR_END: plane_hit

    /// The surface at the hit; the texture coordinates are metres along two perpendicular directions in the plane.
    fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        let near = ray.at(hit.t);
        let position = near + (self.offset - self.normal.dot(near)) * *self.normal;
        let basis = Basis::around(self.normal);
        let error = ROUNDING * (position.abs().max_element() + self.offset.abs());
        Surface {
            texture: vec2(position.dot(*basis.x), position.dot(*basis.y)),
            texture_per_metre: 1.0,
            ..Surface::flat(position, error, self.normal)
        }
    }
}
