//! Instances: a shape that is scaled, rotated and moved, without a copy of it.
//!
//! ```
//! use glam::Mat3;
//! use raybook::prelude::*;
//! use std::sync::Arc;
//!
//! let large = Instance {
//!     shape: Arc::new(Sphere::new(Vec3::ZERO, 1.0)),
//!     scale: 2.0,
//!     rotation: Mat3::IDENTITY,
//!     translation: vec3(0.0, 0.0, 10.0),
//! };
//! let hit = large.hit(&Ray::new(Vec3::ZERO, Dir3::Z), Interval::AHEAD);
//! assert_eq!(hit.map(|hit| hit.t), Some(8.0)); // 10 m to the centre, less 2 · 1 m
//! ```

use crate::math::{aabb::Aabb, dir3::Dir3, interval::Interval, ray::Ray};
use crate::shape::{Hit, ROUNDING, Shape, Surface};
use glam::{Mat3, Vec3};
use std::fmt;
use std::sync::Arc;

/// An instance of a shape: the point p of the shape is at `translation` + `scale` · `rotation` · p.
///
/// Many instances may share one shape: 350 pots are one shape and 350 places.
#[derive(Clone)]
pub struct Instance {
    /// The original shape.
    pub shape: Arc<dyn Shape>,
    /// The scale factor, above 0.
    pub scale: f32,
    /// The rotation: an orthogonal matrix with determinant 1.
    pub rotation: Mat3,
    /// The new place of the shape's origin, in metres.
    pub translation: Vec3,
}

impl fmt::Debug for Instance {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("Instance")
            .field("scale", &self.scale)
            .field("rotation", &self.rotation)
            .field("translation", &self.translation)
            .finish_non_exhaustive()
    }
}

impl Instance {
    // ANCHOR: instance
    /// The ray in the coordinates of the original shape. Distances along it are 1/`scale` times as long.
    fn back(&self, ray: &Ray) -> Ray {
        let turned = self.rotation.transpose();
        Ray::new(
            turned * (ray.origin - self.translation) / self.scale,
            Dir3::new_or(turned * *ray.direction, ray.direction),
        )
    }
    // ANCHOR_END: instance

    /// The interval of the ray in the coordinates of the original shape, exactly: x lies in it if x·`scale`, rounded, lies in
    /// `within`.
    fn stretch(&self, within: Interval) -> Interval {
        Interval::new(-self.least(-within.min), self.least(within.max))
    }

    /// The least x for which x·`scale`, rounded, is not below the limit.
    fn least(&self, limit: f32) -> f32 {
        // The quotient and the product are rounded: the quotient is at most one step off.
        let x = limit / self.scale;
        let x = if x * self.scale < limit {
            x.next_up()
        } else {
            x
        };
        let before = x.next_down();
        if before * self.scale < limit {
            x
        } else {
            before
        }
    }

    /// A direction of the original shape, rotated.
    fn turned(&self, direction: Dir3) -> Dir3 {
        Dir3::new_or(self.rotation * *direction, direction)
    }
}

impl Shape for Instance {
    /// The box around the eight corners of the original shape's box, plus a bound on rounding.
    fn bounds(&self) -> Aabb {
        let Aabb { min, max } = self.shape.bounds();
        if !(min.is_finite() && max.is_finite()) {
            return Aabb {
                min: Vec3::NEG_INFINITY,
                max: Vec3::INFINITY,
            };
        }
        let corner = |i: u32| {
            let of = |axis: usize| {
                if i >> axis & 1 == 0 {
                    min[axis]
                } else {
                    max[axis]
                }
            };
            self.translation + self.scale * (self.rotation * Vec3::new(of(0), of(1), of(2)))
        };
        let Aabb { min, max } = Aabb::of((0..8).map(corner));
        // A corner is rounded three times, and points in the box are rounded differently.
        let pad = Vec3::splat(
            ROUNDING
                * min
                    .abs()
                    .max(max.abs())
                    .max(self.translation.abs())
                    .max_element(),
        );
        Aabb {
            min: min - pad,
            max: max + pad,
        }
    }

    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let hit = self.shape.hit(&self.back(ray), self.stretch(within))?;
        let t = hit.t * self.scale;
        Some(Hit { t, ..hit })
    }

    fn blocks(&self, ray: &Ray, within: Interval) -> bool {
        self.shape.blocks(&self.back(ray), self.stretch(within))
    }

    fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        let local = Hit {
            t: hit.t / self.scale,
            ..*hit
        };
        let surface = self.shape.surface(&self.back(ray), &local);
        let position = self.translation + self.scale * (self.rotation * surface.position);
        let largest = position
            .abs()
            .max(self.translation.abs())
            .max(ray.origin.abs());
        Surface {
            position,
            error: 2.0 * self.scale * surface.error + ROUNDING * largest.max_element(),
            normal: self.turned(surface.normal),
            shading_normal: self.turned(surface.shading_normal),
            texture_per_metre: surface.texture_per_metre / self.scale,
            lift: self.scale * (self.rotation * surface.lift),
            ..surface
        }
    }
}
