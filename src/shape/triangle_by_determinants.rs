//! The hit of a triangle by Cramer's rule, with its four determinants written out.
//!
//! ```
//! use raybook::prelude::*;
//! use raybook::shape::triangle_by_determinants;
//!
//! let triangle = Triangle::new(Vec3::ZERO, Vec3::X, Vec3::Y);
//! let ray = Ray::new(vec3(0.25, 0.5, 3.0), -Dir3::Z);
//! let hit = triangle_by_determinants::hit(&triangle, &ray, Interval::AHEAD);
//! assert_eq!(hit, triangle.hit(&ray, Interval::AHEAD)); // two methods, one answer
//! ```

use crate::math::{interval::Interval, ray::Ray};
use crate::shape::{Hit, triangle::Triangle};
use glam::{Mat3, vec2};

// ANCHOR: hit_by_determinants
/// The same answer as [`Triangle::hit`](crate::shape::Shape::hit): Cramer's rule for the three equations
/// −t·d + b₁·e₁ + b₂·e₂ = s, with s = o − p₀.
///
/// Each unknown is a quotient of two determinants: the right side replaces the unknown's column.
pub fn hit(triangle: &Triangle, ray: &Ray, within: Interval) -> Option<Hit> {
    let Triangle { p0, e1, e2 } = *triangle;
    let (minus_d, s) = (-*ray.direction, ray.origin - p0);
    let all = Mat3::from_cols(minus_d, e1, e2).determinant();
    let t = Mat3::from_cols(s, e1, e2).determinant() / all;
    let b1 = Mat3::from_cols(minus_d, s, e2).determinant() / all;
    let b2 = Mat3::from_cols(minus_d, e1, s).determinant() / all;
    let inside = b1 >= 0.0 && b2 >= 0.0 && b1 + b2 <= 1.0;
    (inside && within.contains(t) && triangle.solvable(all)).then_some(Hit {
        t,
        uv: vec2(b1, b2),
        id: 0,
    })
}
// ANCHOR_END: hit_by_determinants
