//! A shape somewhere else: as large, turned and placed as one wants it, without a copy of it.

use crate::math::{aabb::Aabb, dir3::Dir3, interval::Interval, ray::Ray};
use crate::shape::{Hit, ROUNDING, Shape, Surface};
use glam::{Mat3, Vec3};
use std::fmt;
use std::sync::Arc;

/// A shape whose points p are seen at `to` + `scale` · `turn` · p.
///
/// Many may share one shape: 350 pots are one, and 350 places.
#[derive(Clone)]
pub struct Placed {
    /// The shape where it was made.
    pub shape: Arc<dyn Shape>,
    /// How many times as large it becomes: more than 0.
    pub scale: f32,
    /// How it is turned: a rotation.
    pub turn: Mat3,
    /// Where its origin is put, in metres.
    pub to: Vec3,
}

impl fmt::Debug for Placed {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("Placed")
            .field("scale", &self.scale)
            .field("turn", &self.turn)
            .field("to", &self.to)
            .finish_non_exhaustive()
    }
}

impl Placed {
    // ANCHOR: placed
    /// The ray as the shape sees it, where it was made. A way along it is 1/`scale` times as long.
    fn back(&self, ray: &Ray) -> Ray {
        let turned = self.turn.transpose();
        Ray::new(
            turned * (ray.origin - self.to) / self.scale,
            Dir3::new_or(turned * *ray.direction, ray.direction),
        )
    }
    // ANCHOR_END: placed

    /// A stretch of the ray as the shape sees it, and an ulp or two more: to and fro, its ends are rounded. 0 is not, and what is
    /// ahead stays ahead: structures are fastest there.
    fn stretch(&self, within: Interval) -> Interval {
        let min = (within.min / self.scale).next_down().next_down();
        let max = (within.max / self.scale).next_up().next_up();
        let least = if within.min < 0.0 { min } else { 0.0 };
        Interval::new(min.max(least), max)
    }

    /// A direction of the shape as it is seen.
    fn turned(&self, direction: Dir3) -> Dir3 {
        Dir3::new_or(self.turn * *direction, direction)
    }
}

impl Shape for Placed {
    /// The box of the eight corners of the shape's box.
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
            self.to + self.scale * (self.turn * Vec3::new(of(0), of(1), of(2)))
        };
        let Aabb { min, max } = Aabb::of((0..8).map(corner));
        // A corner is rounded three times, and what is in the box is rounded otherwise.
        let pad = Vec3::splat(ROUNDING * min.abs().max(max.abs()).max(self.to.abs()).max_element());
        Aabb {
            min: min - pad,
            max: max + pad,
        }
    }

    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let (ray, mut stretch) = (self.back(ray), self.stretch(within));
        loop {
            let hit = self.shape.hit(&ray, stretch)?;
            let t = hit.t * self.scale;
            if within.contains(t) || t >= within.max {
                return within.contains(t).then_some(Hit { t, ..hit });
            }
            stretch.min = hit.t; // it was before the true stretch: on to the next
        }
    }

    fn blocks(&self, ray: &Ray, within: Interval) -> bool {
        let blocked = self.shape.blocks(&self.back(ray), self.stretch(within));
        blocked && self.hit(ray, within).is_some()
    }

    fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        let local = Hit {
            t: hit.t / self.scale,
            ..*hit
        };
        let surface = self.shape.surface(&self.back(ray), &local);
        let position = self.to + self.scale * (self.turn * surface.position);
        let largest = position.abs().max(self.to.abs()).max(ray.origin.abs());
        Surface {
            position,
            error: 2.0 * self.scale * surface.error + ROUNDING * largest.max_element(),
            normal: self.turned(surface.normal),
            shading_normal: self.turned(surface.shading_normal),
            texture_per_metre: surface.texture_per_metre / self.scale,
            lift: self.scale * (self.turn * surface.lift),
            ..surface
        }
    }
}
