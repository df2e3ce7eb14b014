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
    let o = way.part("o", o);
    let d = way.part("d", d);
    // p₀ goes into three steps, and whoever takes another point for it does so in one of them.
    let p1 = way.part("p₁", p1);
    let p2 = way.part("p₂", p2);
    let from = way.part("p₀ in e₁", p0);
    let e1 = way.vector("e₁ = p₁ − p₀", "m", p1 - from);
    let from = way.part("p₀ in e₂", p0);
    let e2 = way.vector("e₂ = p₂ − p₀", "m", p2 - from);
    let s1 = way.vector("s₁ = d × e₂", "m", d.cross(e2));
    let determinant = way.number("determinant = s₁·e₁", "m²", s1.dot(e1));
    // The library says which determinants are too small to divide by.
    let solvable = Triangle::new(corners[0], corners[1], corners[2]).solvable(determinant as f32);
    if way.is_zero(
        "the determinant is 0",
        if solvable { determinant } else { 0.0 },
    ) {
        way.remark("The determinant is 0 but for rounding: the ray is parallel to the triangle, or the triangle has no area.");
        return None;
    }
    let from = way.part("p₀ in s", p0);
    let s = way.vector("s = o − p₀", "m", o - from);
    let b1 = way.part("s₁·s", s1.dot(s));
    let b1 = way.number("u = b₁ = s₁·s/determinant", "", b1 / determinant);
    let s2 = way.vector("s₂ = s × e₁", "m²", s.cross(e1));
    let b2 = way.part("s₂·d", s2.dot(d));
    let b2 = way.number("v = b₂ = s₂·d/determinant", "", b2 / determinant);
    let b0 = way.number("b₀ = 1 − b₁ − b₂", "", 1.0 - b1 - b2);
    let e2 = way.part("e₂ in s₂·e₂", e2);
    let t = way.part("s₂·e₂", s2.dot(e2));
    let t = way.number("t = s₂·e₂/determinant", "m", t / determinant);
    let is_outside = way.is_less("b₀ is negative", b0, -EDGE)
        || way.is_less("b₁ is negative", b1, -EDGE)
        || way.is_less("b₂ is negative", b2, -EDGE);
    if is_outside {
        way.remark("A weight is negative: the point is beyond the edge opposite to that corner.");
        None
    } else if rays::counts(way, within, t) {
        Some([
            way.part("t, returned", t),
            way.part("b₁, returned", b1),
            way.part("b₂, returned", b2),
        ])
    } else {
        way.remark("The point is in the triangle, but t is not between min and max.");
        None
    }
}

/// The same by the volumes between the ray and the three edges: all have one sign, or the ray passes by (Plücker's test).
fn by_volumes(asked: &TriangleHit, way: &mut Way) -> Option<[f64; 3]> {
    let (o, d) = rays::parts(&asked.ray);
    let o = way.part("o", o);
    let d = way.part("d", d);
    let a = way.part("a = p₀ − o", asked.p0.as_dvec3() - o);
    let b = way.part("b = p₁ − o", asked.p1.as_dvec3() - o);
    let c = way.part("c = p₂ − o", asked.p2.as_dvec3() - o);
    let v0 = way.part("d·(c × b), the volume opposite to p₀", d.dot(c.cross(b)));
    let v1 = way.part("d·(a × c), the volume opposite to p₁", d.dot(a.cross(c)));
    let v2 = way.part("d·(b × a), the volume opposite to p₂", d.dot(b.cross(a)));
    let whole = way.part("the sum of the three volumes", v0 + v1 + v2);
    let triangle = Triangle::new(asked.p0, asked.p1, asked.p2);
    if way.decides("the volumes are 0", !triangle.solvable(whole as f32)) {
        return None;
    }
    let b0 = way.part("b₀", v0 / whole);
    let b1 = way.part("b₁", v1 / whole);
    let b2 = way.part("b₂", v2 / whole);
    let is_outside = way.is_less("b₀ is negative", b0, -EDGE)
        || way.is_less("b₁ is negative", b1, -EDGE)
        || way.is_less("b₂ is negative", b2, -EDGE);
    let of_a = way.part("b₀ a", b0 * a);
    let of_b = way.part("b₁ b", b1 * b);
    let of_c = way.part("b₂ c", b2 * c);
    let t = way.part("t = (b₀ a + b₁ b + b₂ c)·d", (of_a + of_b + of_c).dot(d));
    (!is_outside && rays::counts(way, asked.within, t)).then_some([t, b1, b2])
}

/// The same by the plane of the triangle first, and then the areas on the inner side of its edges.
fn by_plane(asked: &TriangleHit, way: &mut Way) -> Option<[f64; 3]> {
    let (o, d) = rays::parts(&asked.ray);
    let [p0, p1, p2] = [asked.p0, asked.p1, asked.p2].map(Vec3::as_dvec3);
    let e1 = way.part("e₁ = p₁ − p₀", p1 - p0);
    let e2 = way.part("e₂ = p₂ − p₀", p2 - p0);
    let n = way.part("n = e₁ × e₂", e1.cross(e2));
    let speed = way.part("n·d", n.dot(d));
    let triangle = Triangle::new(asked.p0, asked.p1, asked.p2);
    if way.decides(
        "the ray is parallel to the triangle",
        !triangle.solvable(-speed as f32),
    ) {
        return None;
    }
    let height = way.part("n·(p₀ − o)", n.dot(p0 - o));
    let t = way.part("t = n·(p₀ − o)/(n·d)", height / speed);
    let start = way.part("o in o + t·d", o);
    let along = way.part("t·d", t * d);
    let p = way.part("p = o + t·d", start + along);
    let area = way.part("n·n", n.dot(n));
    let a1 = way.part("n·((p₀ − p₂) × (p − p₂))", n.dot((p0 - p2).cross(p - p2)));
    let a2 = way.part("n·((p₁ − p₀) × (p − p₀))", n.dot((p1 - p0).cross(p - p0)));
    let b1 = way.part("b₁", a1 / area);
    let b2 = way.part("b₂", a2 / area);
    let b0 = way.part("b₀ = 1 − b₁ − b₂", 1.0 - b1 - b2);
    let is_outside = way.is_less("b₀ is negative", b0, -EDGE)
        || way.is_less("b₁ is negative", b1, -EDGE)
        || way.is_less("b₂ is negative", b2, -EDGE);
    (!is_outside && rays::counts(way, asked.within, t)).then_some([t, b1, b2])
}

/// A hit by its numbers.
fn hit([t, b1, b2]: [f64; 3]) -> TriangleHitAnswer {
    let [t, b1, b2] = [t, b1, b2].map(|v| v as f32);
    TriangleHitAnswer { t, b1, b2 }
}

/// On an edge a weight is 0, but for the rounding of the corners in single precision.
const EDGE: f64 = 1e-7;

impl Explained for TriangleHit {
    const WAYS: &'static [fn(&Self, &mut Way) -> Option<TriangleHitAnswer>] = &[
        Self::work,
        |asked, way| by_volumes(asked, way).map(hit),
        |asked, way| by_plane(asked, way).map(hit),
    ];

    fn work(&self, way: &mut Way) -> Option<TriangleHitAnswer> {
        meets(way, &self.ray, self.within, [self.p0, self.p1, self.p2]).map(hit)
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

/// The same by the edges at the second corner.
fn by_the_second(asked: &TriangleNormal, way: &mut Way) -> Option<Vec3> {
    let p0 = way.part("p₀", asked.p0.as_dvec3());
    let p1 = way.part("p₁", asked.p1.as_dvec3());
    let p2 = way.part("p₂", asked.p2.as_dvec3());
    let next = way.part("p₂ − p₁", p2 - p1);
    let back = way.part("p₀ − p₁", p0 - p1);
    let across: DVec3 = way.part("(p₂ − p₁) × (p₀ − p₁)", next.cross(back));
    if way.is_zero("the triangle has no area", across.length()) {
        return None;
    }
    Some(way.part("that, of length 1", across.normalize()).as_vec3())
}

impl Explained for TriangleNormal {
    fn work(&self, way: &mut Way) -> Option<Vec3> {
        let p0 = way.part("p₀", self.p0.as_dvec3());
        let p1 = way.part("p₁", self.p1.as_dvec3());
        let p2 = way.part("p₂", self.p2.as_dvec3());
        let e1 = way.vector("e₁ = p₁ − p₀", "m", p1 - p0);
        let e2 = way.vector("e₂ = p₂ − p₀", "m", p2 - p0);
        let across: DVec3 = way.vector("e₁ × e₂", "m²", e1.cross(e2));
        let length = way.number("|e₁ × e₂|, twice the area", "m²", across.length());
        if way.is_zero("the triangle has no area", length) {
            way.remark("The triangle has no area.");
            return None;
        }
        Some(
            way.vector("(e₁ × e₂)/|e₁ × e₂|", "", across / length)
                .as_vec3(),
        )
    }

    const WAYS: &'static [fn(&Self, &mut Way) -> Option<Vec3>] = &[Self::work, by_the_second];
}
