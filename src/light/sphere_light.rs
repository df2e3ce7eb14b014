//! The spherical light.
//!
//! ```
//! use raybook::prelude::*;
//!
//! let choose = LightSampling::BySolidAngle;
//! let lamp = SphereLight { sphere: Sphere::new(Vec3::ZERO, 1.0), radiance: Rgb::WHITE, choose };
//! // At twice the radius, it is seen in a cone of 30°: sin α = 1/2, Ω = 2π(1 − cos α).
//! let pdf = lamp.pdf(vec3(0.0, 0.0, 2.0), -Dir3::Z);
//! let solid_angle = std::f32::consts::TAU * (1.0 - 0.75_f32.sqrt());
//! assert!((pdf * solid_angle - 1.0).abs() < 1e-4);
//! ```

use crate::image::rgb::Rgb;
use crate::light::extent::{LightSampling, emit, per_steradian, shine};
use crate::light::{Emitted, Light, LightHit, LightSample};
use crate::math::{basis::Basis, dir3::Dir3, interval::Interval, ray::Ray};
use crate::sample::hemisphere::uniform_sphere;
use crate::shape::{Shape, sphere::Sphere};
use glam::{Vec2, Vec3, vec2, vec3};
use std::f32::consts::TAU;

/// A sphere that shines, outwards and inwards, with the same radiance from all points in all directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphereLight {
    /// The sphere.
    pub sphere: Sphere,
    /// L: the radiance, in W·m⁻²·sr⁻¹.
    pub radiance: Rgb,
    /// How the points of the light are chosen.
    pub choose: LightSampling,
}

impl SphereLight {
    // ANCHOR: sample_sphere_light
    /// A direction, uniform over the cone in which the sphere is seen. Its half angle is α, sin α = r/d, with d the distance to
    /// the centre.
    ///
    /// The cone cuts off a cap of the unit sphere with the area Ω = 2π(1 − cos α). The area between two parallel planes is
    /// proportional to their distance (Archimedes), so 1 − cos θ is uniform, from 0 to 1 − cos α. From inside, the light is in
    /// all directions: Ω = 4π.
    fn sample_cone(&self, at: Vec3, u: Vec2) -> Option<LightSample> {
        let (c, r) = (self.sphere.center - at, self.sphere.radius);
        let (d, height) = (c.length(), self.cap(at));
        let x = u.x * height;
        let (cosine, sine) = (1.0 - x, (x * (2.0 - x)).max(0.0).sqrt());
        let (sin_phi, cos_phi) = (TAU * u.y).sin_cos();
        let around = Basis::around(Dir3::new_or(c, Dir3::Y));
        let toward = around.to_world(vec3(sine * cos_phi, sine * sin_phi, cosine));
        // The line meets the sphere at d cos θ ± half the chord: first at the minus sign, or from inside at the plus sign.
        let half_chord = (r * r - d * d * sine * sine).max(0.0).sqrt();
        let side = if self.holds(at) { 1.0 } else { -1.0 };
        let distance = d * cosine + side * half_chord;
        shine(
            Dir3::new(toward)?,
            distance,
            self.radiance,
            1.0 / (TAU * height),
        )
    }
    // ANCHOR_END: sample_sphere_light

    /// 1 − cos α of the cone in which the sphere is seen; 2 from inside.
    ///
    /// For a small sphere, cos α rounds to 1 in `f32`; sin²α/(1 + cos α) is the same number without cancellation.
    fn cap(&self, at: Vec3) -> f32 {
        if self.holds(at) {
            return 2.0;
        }
        let squared = self.sphere.radius.powi(2) / at.distance_squared(self.sphere.center);
        squared / (1.0 + (1.0 - squared).max(0.0).sqrt())
    }

    /// A point, uniform over the area that is seen: from outside a cap of the height r − r²/d, from inside the whole sphere.
    fn sample_area(&self, at: Vec3, u: Vec2) -> Option<LightSample> {
        let x = u.x * self.seen_height(at);
        let (cosine, sine) = (1.0 - x, (x * (2.0 - x)).max(0.0).sqrt());
        let (sin_phi, cos_phi) = (TAU * u.y).sin_cos();
        let around = Basis::around(Dir3::new_or(at - self.sphere.center, Dir3::Y));
        let outward = around.to_world(vec3(sine * cos_phi, sine * sin_phi, cosine));
        let r = self.sphere.center + self.sphere.radius * outward - at;
        let pdf = self.area_pdf(at, r, Dir3::new(outward)?);
        shine(Dir3::new(r)?, r.length(), self.radiance, pdf)
    }

    /// The density per steradian of a point that was chosen by area; `r` is the vector from `at` to the point.
    fn area_pdf(&self, at: Vec3, r: Vec3, outward: Dir3) -> f32 {
        let area = TAU * self.sphere.radius.powi(2) * self.seen_height(at);
        let facing = if self.holds(at) { -outward } else { outward };
        per_steradian(1.0 / area, r, facing)
    }

    /// The height of the part of the sphere that is seen, in radii: 1 − r/d from outside, 2 from inside.
    fn seen_height(&self, at: Vec3) -> f32 {
        if self.holds(at) {
            return 2.0;
        }
        let d = at.distance(self.sphere.center);
        (d - self.sphere.radius) / d
    }

    /// Whether a point is inside the sphere or on it.
    fn holds(&self, at: Vec3) -> bool {
        at.distance(self.sphere.center) <= self.sphere.radius
    }
}

impl Light for SphereLight {
    fn sample(&self, at: Vec3, u: Vec2) -> Option<LightSample> {
        match self.choose {
            LightSampling::ByArea => self.sample_area(at, u),
            LightSampling::BySolidAngle => self.sample_cone(at, u),
        }
    }

    fn seen(&self, ray: &Ray, farthest: f32) -> Option<LightHit> {
        let t = self.sphere.hit(ray, Interval::AHEAD)?.t;
        if t > farthest {
            return None;
        }
        let (at, r) = (ray.origin, t * *ray.direction);
        let pdf = match self.choose {
            LightSampling::ByArea => self.area_pdf(at, r, self.sphere.normal_at(at + r)),
            LightSampling::BySolidAngle => 1.0 / (TAU * self.cap(at)),
        };
        Some(LightHit {
            t,
            radiance: self.radiance,
            pdf,
        })
    }

    /// From a point that is uniform over the area, 4π r², by [`emit`]: half of the photons outwards, and half inwards.
    ///
    /// The sphere shines to both sides, so its flux is 2·π·4π r²·L.
    fn emit(&self, place: Vec2, direction: Vec2) -> Option<Emitted> {
        let (r, outward) = (self.sphere.radius, uniform_sphere(place));
        let at = self.sphere.center + r * *outward;
        // Twice u.x is uniform over [0, 1) in each half.
        let (side, u) = if direction.x < 0.5 {
            (outward, vec2(2.0 * direction.x, direction.y))
        } else {
            (-outward, vec2(2.0 * direction.x - 1.0, direction.y))
        };
        let area = 2.0 * (2.0 * TAU * r * r);
        Some(emit(at, side, area, self.radiance, u))
    }
}
