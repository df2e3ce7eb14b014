//! The triangle, hit by the method of Möller and Trumbore.
//!
//! ```
//! use raybook::prelude::*;
//!
//! let triangle = Triangle::new(Vec3::ZERO, Vec3::X, Vec3::Y);
//! let ray = Ray::new(vec3(0.25, 0.5, 3.0), -Dir3::Z);
//! let hit = triangle.hit(&ray, Interval::AHEAD).expect("inside");
//! assert_eq!((hit.t, hit.uv), (3.0, vec2(0.25, 0.5))); // the barycentric coordinates b₁ and b₂
//! ```

use crate::math::{aabb::Aabb, dir3::Dir3, domain::AREA_MIN, interval::Interval, ray::Ray};
use crate::shape::{Hit, ROUNDING, Shape, Surface};
use glam::{Vec3, vec2};

/// The points p₀ + b₁·e₁ + b₂·e₂ with b₁ ≥ 0, b₂ ≥ 0, b₁ + b₂ ≤ 1.
///
/// The outside is the side from which p₀, p₁, p₂ are seen counter-clockwise. Both sides can be hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle {
    /// The first corner.
    pub p0: Vec3,
    /// e₁ = p₁ − p₀.
    pub e1: Vec3,
    /// e₂ = p₂ − p₀.
    pub e2: Vec3,
}

impl Triangle {
    /// A triangle from its corners.
    pub fn new(p0: Vec3, p1: Vec3, p2: Vec3) -> Self {
        Self {
            p0,
            e1: p1 - p0,
            e2: p2 - p0,
        }
    }

    /// The three corners.
    pub fn corners(&self) -> [Vec3; 3] {
        [self.p0, self.p0 + self.e1, self.p0 + self.e2]
    }

    // ANCHOR: triangle_normal
    /// The outward normal: e₁ × e₂, normalised; `None` for a triangle without area.
    pub fn normal(&self) -> Option<Dir3> {
        Dir3::new(self.e1.cross(self.e2))
    }
    // ANCHOR_END: triangle_normal

    // ANCHOR: solvable
    /// Whether the determinant |−d e₁ e₂| is more than the rounding errors of its six products, whose sizes add up to
    /// at most ‖e₁‖₁·‖e₂‖₁, where ‖e‖₁ = |eₓ| + |e_y| + |e_z|.
    ///
    /// The exact determinant is 0 for a triangle without area, and for a ray in the triangle's plane. But products that should
    /// cancel are rounded, and a rest remains: a division by this rest makes hits out of noise. A determinant below `AREA_MIN` is
    /// refused too, because then the numerators have lost their digits (see the [domain](crate::math::domain)).
    pub fn solvable(&self, determinant: f32) -> bool {
        /// At most five roundings of 2⁻²⁴ in a row; four are enough, because the sizes of products that cancel add up to less
        /// than their bound.
        const ROUNDINGS: f32 = 4.0 * (f32::EPSILON / 2.0);
        let products = self.e1.abs().element_sum() * self.e2.abs().element_sum();
        determinant.abs() > (ROUNDINGS * products).max(AREA_MIN)
    }
    // ANCHOR_END: solvable
}

impl Shape for Triangle {
    fn bounds(&self) -> Aabb {
        Aabb::of(self.corners())
    }

    // ANCHOR: triangle_hit
    /// Solves o + t·d = p₀ + b₁·e₁ + b₂·e₂ for (t, b₁, b₂); `uv` is (b₁, b₂).
    ///
    /// By Cramer's rule with |a b c| = (a × b)·c, and s₁ = d × e₂, s = o − p₀, s₂ = s × e₁:
    /// (t, b₁, b₂) = (s₂·e₂, s₁·s, s₂·d) / s₁·e₁ (Möller and Trumbore 1997).
    ///
    /// For a triangle without area, or a ray in the triangle's plane, s₁·e₁ is 0 or a rounding error of 0, and the quotients are
    /// infinite, NaN or noise. Then one of the comparisons is false, or [`Triangle::solvable`] is false.
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let s1 = ray.direction.cross(self.e2);
        let determinant = s1.dot(self.e1);
        let inverse = 1.0 / determinant;
        let s = ray.origin - self.p0;
        let b1 = s1.dot(s) * inverse;
        let s2 = s.cross(self.e1);
        let b2 = s2.dot(*ray.direction) * inverse;
        let t = s2.dot(self.e2) * inverse;
        let inside = b1 >= 0.0 && b2 >= 0.0 && b1 + b2 <= 1.0;
        (inside && within.contains(t) && self.solvable(determinant)).then_some(Hit {
            t,
            uv: vec2(b1, b2),
            id: 0,
        })
    }
    // ANCHOR_END: triangle_hit

    fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        let normal = self.normal().unwrap_or(-ray.direction);
        // |e₁ × e₂|, without its square, which may underflow.
        let twice_area = self.e1.cross(self.e2).dot(*normal).abs();
        let (a, b) = (self.e1.length(), self.e2.length());
        // The more parallel e₁ and e₂ are, the more digits of the distance to the plane `hit` loses: a factor 1/sin of their
        // angle.
        let lost = (a * b / twice_area).max(1.0);
        let longest = a.max(b);
        let position = self.p0 + hit.uv.x * self.e1 + hit.uv.y * self.e2;
        let error = ROUNDING * (self.p0.abs().max_element() + lost * longest);
        Surface {
            texture: hit.uv,
            texture_per_metre: twice_area.sqrt().recip(),
            ..Surface::flat(position, error, normal)
        }
    }
}
