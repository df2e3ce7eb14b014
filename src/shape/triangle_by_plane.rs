//! The hit of a triangle in two steps: first the hit of its plane, then the test whether the point is inside.
//!
//! ```
//! use raybook::prelude::*;
//! use raybook::shape::triangle_by_plane;
//!
//! let triangle = Triangle::new(Vec3::ZERO, Vec3::X, Vec3::Y);
//! let distance = |x| triangle_by_plane::hit(&triangle, &Ray::new(vec3(x, 0.5, 3.0), -Dir3::Z), Interval::AHEAD);
//! assert_eq!(distance(0.25).map(|hit| hit.t), Some(3.0));
//! assert!(distance(0.75).is_none()); // meets the plane, but b₁ + b₂ > 1
//! ```

use crate::math::{interval::Interval, ray::Ray};
use crate::shape::{Hit, triangle::Triangle};
use glam::vec2;

// ANCHOR: hit_by_plane
/// The same answer as [`Triangle::hit`](crate::shape::Shape::hit): the point p where the ray meets the plane n·p = n·p₀ with
/// n = e₁ × e₂, if p is to the left of all three edges, as seen from outside.
///
/// With q = p − p₀, twice the area of (p₀, p, p₂) is (q × e₂)·n/|n|. So b₁ = (q × e₂)·n/(n·n), and b₂ = (e₁ × q)·n/(n·n).
pub fn hit(triangle: &Triangle, ray: &Ray, within: Interval) -> Option<Hit> {
    let Triangle { p0, e1, e2 } = *triangle;
    let n = e1.cross(e2);
    let determinant = n.dot(*ray.direction);
    let t = n.dot(p0 - ray.origin) / determinant;
    if !within.contains(t) {
        return None;
    }
    let q = ray.at(t) - p0;
    let b1 = q.cross(e2).dot(n) / n.length_squared();
    let b2 = e1.cross(q).dot(n) / n.length_squared();
    let inside = b1 >= 0.0 && b2 >= 0.0 && b1 + b2 <= 1.0;
    (inside && triangle.solvable(determinant)).then_some(Hit {
        t,
        uv: vec2(b1, b2),
        id: 0,
    })
}
// ANCHOR_END: hit_by_plane
