//! Chapter 3: `solve_quadratic`, `sphere_hit`, `sphere_normal`.

use crate::exercise::exercises;
use glam::{Vec2, Vec3};
use raybook::math::{interval::Interval, quadratic, ray::Ray};
use raybook::shape::{Shape, sphere::Sphere};

exercises! { ($) ch03_sphere
    /// Return both real roots of a·t² + b·t + c = 0, the smaller one first. There is no answer where no root is real,
    /// or where a is 0. Lose no digits where b² is much larger than 4ac.
    SolveQuadratic: solve_quadratic(
        /// The coefficient of t².
        a: f32,
        /// The coefficient of t.
        b: f32,
        /// The constant term.
        c: f32,
    ) -> (
        /// Both roots, the smaller one first; none if no root is real, or a is 0.
        t: Option<Vec2>,
    ) {
        quadratic::solve(a, b, c).map(Vec2::from)
    }

    /// Return the smallest distance t between min and max at which the ray meets the sphere; a miss has no answer.
    /// Both ends are excluded: min < t < max. Lose no digits where the sphere is small and far away.
    ///
    /// In Rust: the distance as `Some(Hit { t, uv: Vec2::ZERO, id: 0 })`.
    SphereHit: sphere_hit(
        /// The ray.
        ray: Ray,
        /// The distances that count: min < t < max, in metres.
        within: Interval,
        /// The sphere's centre, in metres.
        center: Vec3,
        /// The sphere's radius, in metres,
        radius: f32 [above 0],
    ) -> (
        /// The distance along the ray, in metres; none for a miss.
        t: Option<f32>,
    ) {
        Sphere { center, radius }.hit(&ray, within).map(|hit| hit.t)
    }

    /// Return the unit vector that points out of the sphere at its point p.
    ///
    /// In Rust: `Dir3::new_or(v, Dir3::Y)` is the direction of a vector v of any length, and Y where v has none.
    SphereNormal: sphere_normal(
        /// The sphere's centre, in metres.
        center: Vec3,
        /// The sphere's radius, in metres,
        radius: f32 [above 0],
        /// A point on the sphere's surface, in metres.
        p: Vec3,
    ) -> (
        /// The normal at p, of length 1, outwards.
        normal: Vec3,
    ) {
        *Sphere { center, radius }.normal_at(p)
    }
}
