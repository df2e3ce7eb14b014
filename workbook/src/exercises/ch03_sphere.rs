//! Chapter 3: `solve_quadratic`, `sphere_hit`, `sphere_normal`.

use raybook::math::{interval::Interval, quadratic, ray::Ray};
use raybook::shape::{Shape, sphere::Sphere};
use crate::exercise::{Asked, Exercise};
use crate::row::row;
use glam::{Vec2, Vec3};

/// This chapter's exercises, in order.
pub const EXERCISES: &[&dyn Asked] = &[&SolveQuadratic, &SphereHit, &SphereNormal];

/// See [`Exercise::TASK`].
pub struct SolveQuadratic;

row! {
    /// The coefficients of a·t² + b·t + c = 0.
    pub struct Coefficients {
        /// a.
        pub a: f32,
        /// b.
        pub b: f32,
        /// c.
        pub c: f32,
    }
}

impl Exercise for SolveQuadratic {
    type Question = Coefficients;
    type Answer = Option<Vec2>;
    const NAME: &'static str = "solve_quadratic";
    const ANSWER: &'static str = "t";
    const TASK: &'static str = "Return both real roots of a·t² + b·t + c = 0, the smaller first, or None where there is none or a is 0; \
        lose no digits where b² is much larger than 4ac.";

    fn answer(q: &Self::Question) -> Self::Answer {
        quadratic::solve(q.a, q.b, q.c).map(Vec2::from)
    }
}

/// See [`Exercise::TASK`].
pub struct SphereHit;

row! {
    /// A ray, the distances that count, and a sphere.
    pub struct SphereHitQuestion {
        /// The ray.
        pub ray: Ray,
        /// Only t with min < t < max counts.
        pub within: Interval,
        /// The sphere's centre.
        pub center: Vec3,
        /// The sphere's radius.
        pub radius: f32,
    }
}

impl Exercise for SphereHit {
    type Question = SphereHitQuestion;
    type Answer = Option<f32>;
    const NAME: &'static str = "sphere_hit";
    const ANSWER: &'static str = "t";
    const TASK: &'static str = "Return the smallest distance t in the interval (min < t < max) at which the ray meets the sphere, \
        as `Hit { t, uv: Vec2::ZERO, id: 0 }`, or None; lose no digits where the sphere is small and far away.";

    fn answer(q: &Self::Question) -> Self::Answer {
        Sphere::new(q.center, q.radius)
            .hit(&q.ray, q.within)
            .map(|hit| hit.t)
    }
}

/// See [`Exercise::TASK`].
pub struct SphereNormal;

row! {
    /// A sphere and a point on it.
    pub struct SphereNormalQuestion {
        /// The sphere's centre.
        pub center: Vec3,
        /// The sphere's radius.
        pub radius: f32,
        /// A point of the sphere.
        pub p: Vec3,
    }
}

impl Exercise for SphereNormal {
    type Question = SphereNormalQuestion;
    type Answer = Vec3;
    const NAME: &'static str = "sphere_normal";
    const ANSWER: &'static str = "normal";
    const TASK: &'static str =
        "Return the unit vector that points out of the sphere at its point p.";

    fn answer(q: &Self::Question) -> Self::Answer {
        *Sphere::new(q.center, q.radius).normal_at(q.p)
    }
}
