//! Chapter 6: the triangle, by the method of Möller and Trumbore, drawn in its own plane.

use super::Explained;
use super::diagram::{Diagram, Ink};
use super::rays;
use super::section::Section;
use super::way::Way;
use glam::{DVec3, Vec3, dvec2};
use raybook::math::{interval::Interval, ray::Ray};
use raybook::shape::triangle::Triangle;
use raybook_workbook::exercises::ch06_triangle::{TriangleHit, TriangleHitAnswer, TriangleNormal};

/// The distance at which a ray meets a triangle, and the weights of its second and third corner.
pub fn meets(way: &mut Way, ray: &Ray, within: Interval, corners: [Vec3; 3]) -> Option<[f64; 3]> {
    let (o, d) = rays::parts(ray);
    let [p0, p1, p2] = corners.map(Vec3::as_dvec3);
    let e1 = way.vector("e₁ = p₁ − p₀", "m", p1 - p0);
    let e2 = way.vector("e₂ = p₂ − p₀", "m", p2 - p0);
    let s1 = way.vector("s₁ = d × e₂", "m", d.cross(e2));
    let determinant = way.number("determinant = s₁·e₁", "m²", s1.dot(e1));
    // The library says which determinants are too small to divide by.
    if !Triangle::new(corners[0], corners[1], corners[2]).solvable(determinant as f32) {
        way.remark("The determinant is 0 but for rounding: the ray is parallel to the triangle, or the triangle has no area.");
        return None;
    }
    let s = way.vector("s = o − p₀", "m", o - p0);
    let b1 = way.number("u = b₁ = s₁·s/determinant", "", s1.dot(s) / determinant);
    let s2 = way.vector("s₂ = s × e₁", "m²", s.cross(e1));
    let b2 = way.number("v = b₂ = s₂·d/determinant", "", s2.dot(d) / determinant);
    let b0 = way.number("b₀ = 1 − b₁ − b₂", "", 1.0 - b1 - b2);
    let t = way.number("t = s₂·e₂/determinant", "m", s2.dot(e2) / determinant);
    if [b0, b1, b2].into_iter().any(|b| b < -EDGE) {
        way.remark("A weight is negative: the point is beyond the edge opposite to that corner.");
        None
    } else if rays::counts(way, within, t) {
        Some([t, b1, b2])
    } else {
        way.remark("The point is in the triangle, but t is not between min and max.");
        None
    }
}

/// On an edge a weight is 0, but for the rounding of the corners in single precision.
const EDGE: f64 = 1e-7;

impl Explained for TriangleHit {
    fn work(&self, way: &mut Way) -> Option<TriangleHitAnswer> {
        let [t, b1, b2] =
            meets(way, &self.ray, self.within, [self.p0, self.p1, self.p2])?.map(|v| v as f32);
        Some(TriangleHitAnswer { t, b1, b2 })
    }

    fn draw(
        &self,
        right: &Option<TriangleHitAnswer>,
        yours: Option<&Option<TriangleHitAnswer>>,
    ) -> Option<Diagram> {
        let (o, d) = rays::parts(&self.ray);
        let corners = [self.p0, self.p1, self.p2].map(Vec3::as_dvec3);
        let [p0, e1, e2] = [corners[0], corners[1] - corners[0], corners[2] - corners[0]];
        let section = Section::spanned(p0, e1, e2);
        let mut drawing =
            Diagram::new("The triangle in its own plane, and where the ray meets the plane");
        drawing.area(&corners.map(|p| section.at(p)), Ink::Shape);
        let middle = section.at((corners[0] + corners[1] + corners[2]) / 3.0);
        for (p, name) in corners.iter().zip(["p₀", "p₁", "p₂"]) {
            let p = section.at(*p);
            drawing.label(p, (p - middle).normalize_or_zero(), name, Ink::Shape);
        }
        let n = e1.cross(e2);
        let meets = o + (p0 - o).dot(n) / d.dot(n) * d;
        let size = e1.length().max(e2.length());
        // A ray that is nearly parallel meets the plane where nobody looks.
        if meets.distance(p0) < 3.0 * size {
            drawing.point(section.at(meets), Ink::Ray);
            drawing.label(section.at(meets), dvec2(-0.8, 0.0), "the ray", Ink::Ray);
        }
        let yours = yours.and_then(Option::as_ref);
        for (hit, ink, beside, name) in rays::answers(right.as_ref(), yours) {
            let p = f64::from(hit.b1) * e1 + f64::from(hit.b2) * e2;
            if p.length() < 4.0 * size {
                drawing.point(section.along(p), ink);
            }
            let p = p.clamp_length_max(4.0 * size);
            drawing.label(
                section.along(p),
                beside,
                format!("{name}: t = {}, b1 = {}, b2 = {}", hit.t, hit.b1, hit.b2),
                ink,
            );
        }
        Some(drawing)
    }
}

impl Explained for TriangleNormal {
    fn work(&self, way: &mut Way) -> Option<Vec3> {
        let [p0, p1, p2] = [self.p0, self.p1, self.p2].map(Vec3::as_dvec3);
        let e1 = way.vector("e₁ = p₁ − p₀", "m", p1 - p0);
        let e2 = way.vector("e₂ = p₂ − p₀", "m", p2 - p0);
        let across: DVec3 = way.vector("e₁ × e₂", "m²", e1.cross(e2));
        let length = way.number("|e₁ × e₂|, twice the area", "m²", across.length());
        if length == 0.0 {
            way.remark("The triangle has no area.");
            return None;
        }
        Some(
            way.vector("(e₁ × e₂)/|e₁ × e₂|", "", across / length)
                .as_vec3(),
        )
    }
}
