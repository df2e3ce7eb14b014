//! The sphere.
//!
//! ```
//! use raybook::prelude::*;
//!
//! let ball = Sphere::new(vec3(0.0, 0.0, 5.0), 1.0);
//! let hit = ball.hit(&Ray::new(Vec3::ZERO, Dir3::Z), Interval::AHEAD);
//! assert_eq!(hit.map(|hit| hit.t), Some(4.0));
//! assert!(Sphere::checked(Vec3::ZERO, 0.0).is_err()); // a point is no sphere
//! ```

use crate::math::domain::LARGEST;
use crate::math::{aabb::Aabb, dir3::Dir3, interval::Interval, quadratic, ray::Ray};
use crate::shape::{Hit, ROUNDING, Shape, Surface};
use glam::{Vec2, Vec3, vec2};
use std::f32::consts::{PI, TAU};

/// All points p with |p − c| = r. The normal points outwards, away from c.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// c, in metres.
    pub center: Vec3,
    /// r > 0, in metres.
    pub radius: f32,
}

/// Why numbers do not make a sphere.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum SphereError {
    /// The centre is outside the domain, or NaN.
    #[error("a sphere's centre must be at most {LARGEST:e} m from 0 along each axis, and is {0}")]
    Center(Vec3),
    /// The radius is 0 or negative, outside the domain, or NaN.
    #[error("a sphere's radius must be above 0 and at most {LARGEST:e} m, and is {0}")]
    Radius(f32),
}

impl Sphere {
    /// A sphere from its centre and radius, in metres.
    ///
    /// # Panics
    /// If they are outside the [domain](crate::math::domain). For numbers from a file, use [`Sphere::checked`].
    #[track_caller]
    pub fn new(center: Vec3, radius: f32) -> Self {
        match Self::checked(center, radius) {
            Ok(sphere) => sphere,
            Err(error) => panic!("{error}"),
        }
    }

    /// A sphere from its centre and radius, in metres.
    ///
    /// # Errors
    /// If they are outside the [domain](crate::math::domain); a radius of 0 is.
    pub fn checked(center: Vec3, radius: f32) -> Result<Self, SphereError> {
        let near = center.abs().cmple(Vec3::splat(LARGEST)).all();
        if !near {
            Err(SphereError::Center(center))
        } else if !(radius > 0.0 && radius <= LARGEST) {
            Err(SphereError::Radius(radius))
        } else {
            Ok(Self { center, radius })
        }
    }

    // ANCHOR: sphere_normal
    /// The outward normal at a point p of the sphere: (p − c)/r.
    pub fn normal_at(&self, p: Vec3) -> Dir3 {
        Dir3::new_or(p - self.center, Dir3::Y)
    }
    // ANCHOR_END: sphere_normal
}

impl Shape for Sphere {
    fn bounds(&self) -> Aabb {
        Aabb {
            min: self.center - self.radius,
            max: self.center + self.radius,
        }
    }

    // ANCHOR: sphere_hit
    /// Solves |o + t·d − c|² = r² for t.
    ///
    /// From far away, the discriminant of this equation is the difference of two huge squares, and its digits are lost.
    /// So t is measured from the point p where the ray passes closest to the centre: t = (c − o)·d + s. The equation
    /// s² + 2(p − c)·d s + |p − c|² − r² = 0 has no larger numbers than necessary (after Haines et al. 2019).
    /// Without rounding, (p − c)·d would be 0; keeping this term corrects the rounding of p along the ray.
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let from_center = ray.origin - self.center;
        let closest = -from_center.dot(*ray.direction);
        let p = from_center + closest * *ray.direction;
        let (near, far) = quadratic::solve(
            1.0,
            2.0 * p.dot(*ray.direction),
            p.length_squared() - self.radius * self.radius,
        )?;
        let s = [near, far]
            .into_iter()
            .find(|s| within.contains(closest + s))?;
        Some(Hit {
            t: closest + s,
            uv: Vec2::ZERO,
            id: 0,
        })
    }
    // ANCHOR_END: sphere_hit

    fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        // t's last digit may be larger than the whole sphere. So t only tells whether the hit is before or behind the point
        // where the ray passes closest to the centre; the distance from this point follows from Pythagoras' theorem.
        let from_center = ray.origin - self.center;
        let closest = -from_center.dot(*ray.direction);
        let p = from_center + closest * *ray.direction;
        let half_chord = (self.radius * self.radius - p.length_squared())
            .max(0.0)
            .sqrt();
        let s = if hit.t > closest {
            half_chord
        } else {
            -half_chord
        };
        let normal = Dir3::new_or(p + s * *ray.direction, Dir3::Y);
        let position = self.center + self.radius * *normal;
        let error = ROUNDING * (self.center.abs().max_element() + self.radius);
        // At the latitude φ, u grows by 1 over 2πr cos φ metres to the east, and v by 1 over πr metres to the north.
        let cosine = (1.0 - normal.y * normal.y).max(f32::EPSILON).sqrt();
        Surface {
            texture: longitude_latitude(normal),
            texture_per_metre: (2.0 * PI * PI * cosine).sqrt().recip() / self.radius,
            ..Surface::flat(position, error, normal)
        }
    }
}

/// Longitude and latitude as texture coordinates in [0, 1]²: u = ½ at +z, growing to the east, towards +x; v from the south pole
/// (−y), 0, to the north pole, 1.
fn longitude_latitude(n: Dir3) -> Vec2 {
    vec2(
        n.x.atan2(n.z) / TAU + 0.5,
        n.y.clamp(-1.0, 1.0).asin() / PI + 0.5,
    )
}
