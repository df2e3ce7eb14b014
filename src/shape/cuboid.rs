//! The axis-aligned box.
//!
//! ```
//! use raybook::prelude::*;
//!
//! let cube = Cuboid::between(Vec3::ZERO, vec3(1.0, 1.0, 1.0));
//! let distance = |z| cube.hit(&Ray::new(vec3(0.5, 0.5, z), Dir3::Z), Interval::AHEAD).map(|hit| hit.t);
//! assert_eq!(distance(-2.0), Some(2.0)); // where the ray enters
//! assert_eq!(distance(0.25), Some(0.75)); // from inside, where it leaves
//! ```

use crate::math::{aabb::Aabb, dir3::Dir3, interval::Interval, ray::Ray, slab};
use crate::shape::{Hit, ROUNDING, Shape, Surface};
use glam::{Vec2, Vec3};

/// The six faces of an axis-aligned box. (In Rust, `Box` is the name of a pointer.)
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cuboid {
    /// The box.
    pub bounds: Aabb,
}

impl Cuboid {
    /// The box between any two opposite corners, in metres.
    pub fn between(a: Vec3, b: Vec3) -> Self {
        Self {
            bounds: Aabb::of([a, b]),
        }
    }
}

impl Shape for Cuboid {
    fn bounds(&self) -> Aabb {
        self.bounds
    }

    /// Clips the whole line by the box. The ray hits the box where the line enters or, from inside, where it leaves.
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let line = Interval::new(f32::NEG_INFINITY, f32::INFINITY);
        let inside = slab::clip(&self.bounds, ray, line)?;
        let t = [inside.min, inside.max]
            .into_iter()
            .find(|&t| within.contains(t))?;
        Some(Hit {
            t,
            uv: Vec2::ZERO,
            id: 0,
        })
    }

    /// The surface of the face whose plane the ray meets nearest to t. Texture coordinates run over each face from 0 to 1.
    fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        let Aabb { min, max } = self.bounds;
        // 0/0: the ray runs in this face's plane, and has hit another face; glam's a.min(∞) is ∞ for NaN.
        let off = |planes: Vec3| {
            let t = (planes - ray.origin) / *ray.direction;
            (t - hit.t).abs().min(Vec3::INFINITY)
        };
        let (below, above) = (off(min), off(max));
        let axis = below.min(above).min_position();
        let outward = match below[axis].total_cmp(&above[axis]) {
            std::cmp::Ordering::Less => -1.0,
            std::cmp::Ordering::Greater => 1.0,
            // A box without thickness: the side that the ray sees.
            std::cmp::Ordering::Equal => -1.0_f32.copysign(ray.direction[axis]),
        };
        let mut position = ray.at(hit.t).max(min).min(max);
        position[axis] = if outward < 0.0 { min[axis] } else { max[axis] };
        let mut normal = Vec3::ZERO;
        normal[axis] = outward;
        let normal = Dir3::new_or(normal, Dir3::Y);
        let size = (max - min).max(Vec3::splat(f32::MIN_POSITIVE));
        let across = (position - min) / size;
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        Surface {
            texture: Vec2::new(across[u], across[v]),
            texture_per_metre: (size[u].sqrt() * size[v].sqrt()).recip(),
            ..Surface::flat(position, ROUNDING * position.abs().max_element(), normal)
        }
    }
}
