//! Chapter 7: what lies between a triangle's corners, normals at vertices, and the nearest triangle of a list.

use super::Explained;
use super::nearest::Nearest;
use super::way::{Value, Way};
use glam::{DVec2, DVec3, Vec2, Vec3};
use raybook_workbook::exercises::ch07_mesh::{
    InterpolateNormal, InterpolateTexture, MeshHit, MeshHitAnswer, VertexNormals,
};
use std::ops::{Add, Mul, Sub};

/// The weights of the three corners.
fn weights(way: &mut Way, b: Vec2) -> [f64; 3] {
    let b1 = way.part("b₁", f64::from(b.x));
    let b2 = way.part("b₂", f64::from(b.y));
    let [first, second] = [way.part("b₁ in b₀", b1), way.part("b₂ in b₀", b2)];
    let b0 = way.number("b₀ = 1 − b₁ − b₂", "", 1.0 - first - second);
    [
        b0,
        way.part("b₁, the second corner's weight", b1),
        way.part("b₂, the third corner's weight", b2),
    ]
}

/// The same from the first corner along the two edges.
fn along_edges<V>(way: &mut Way, b: Vec2, [v0, v1, v2]: [V; 3]) -> V
where
    V: Value + Add<Output = V> + Sub<Output = V>,
    f64: Mul<V, Output = V>,
{
    let b1 = way.part("b₁", f64::from(b.x));
    let b2 = way.part("b₂", f64::from(b.y));
    let first = way.part("what the first corner has", v0);
    let second = way.part("what the second corner has", v1);
    let third = way.part("what the third corner has", v2);
    let from = way.part("what the first corner has, in the first edge", v0);
    let to_second = way.part("from the first corner to the second", second - from);
    let from = way.part("what the first corner has, in the second edge", v0);
    let to_third = way.part("from the first corner to the third", third - from);
    let along = way.part("b₁ times the first of these", b1 * to_second);
    let aside = way.part("b₂ times the second of these", b2 * to_third);
    way.part("the sum", first + along + aside)
}

impl Explained for InterpolateNormal {
    const WAYS: &'static [fn(&Self, &mut Way) -> Vec3] = &[Self::work, |asked, way| {
        let normals = [asked.n0, asked.n1, asked.n2].map(|n| n.as_dvec3());
        let sum = along_edges(way, asked.b, normals);
        let normal = sum.try_normalize().unwrap_or(normals[0]);
        way.part("the same of length 1", normal).as_vec3()
    }];

    fn work(&self, way: &mut Way) -> Vec3 {
        let b = weights(way, self.b);
        let [n0, n1, n2] = [self.n0, self.n1, self.n2].map(|n| n.as_dvec3());
        let n0 = way.part("n₀", n0);
        let n1 = way.part("n₁", n1);
        let n2 = way.part("n₂", n2);
        let sum = b[0] * n0 + b[1] * n1 + b[2] * n2;
        let sum: DVec3 = way.vector("b₀n₀ + b₁n₁ + b₂n₂", "", sum);
        let length = way.number("its length", "", sum.length());
        let normal = if way.is_less("the sum has a length", 0.0, length) {
            sum / length
        } else {
            n0
        };
        way.vector("the same of length 1", "", normal).as_vec3()
    }
}

impl Explained for InterpolateTexture {
    const WAYS: &'static [fn(&Self, &mut Way) -> Vec2] = &[Self::work, |asked, way| {
        let places = [asked.t0, asked.t1, asked.t2].map(Vec2::as_dvec2);
        along_edges(way, asked.b, places).as_vec2()
    }];

    fn work(&self, way: &mut Way) -> Vec2 {
        let b = weights(way, self.b);
        let [t0, t1, t2]: [DVec2; 3] = [self.t0, self.t1, self.t2].map(Vec2::as_dvec2);
        let t0 = way.part("t₀", t0);
        let t1 = way.part("t₁", t1);
        let t2 = way.part("t₂", t2);
        way.pair("b₀t₀ + b₁t₁ + b₂t₂", "", b[0] * t0 + b[1] * t1 + b[2] * t2)
            .as_vec2()
    }
}

/// What a triangle with these two edges, whose cross product is given, adds to the sums of its vertices.
type Given = fn(&mut Way, [DVec3; 2], DVec3) -> DVec3;

/// The normals of vertices, to which each triangle gives something.
fn summed(asked: &VertexNormals, way: &mut Way, given: Given) -> Vec<Vec3> {
    let of_none = way.part("the normal of a vertex without an area", DVec3::Y);
    let nothing = way.part("what a vertex's sum begins with", DVec3::ZERO);
    let mut sums = vec![nothing; asked.positions.len()];
    for (i, triangle) in asked.triangles.iter().enumerate() {
        let corners = [triangle.a, triangle.b, triangle.c];
        let [p0, p1, p2] = corners.map(|k| asked.positions[k as usize].as_dvec3());
        let p0 = way.part("p₀", p0);
        let p1 = way.part("p₁", p1);
        let p2 = way.part("p₂", p2);
        let e1 = way.part("e₁ = p₁ − p₀", p1 - p0);
        let e2 = way.part("e₂ = p₂ − p₀", p2 - p0);
        let name = format!("triangle {i}, e₁ × e₂: its normal, twice as long as its area");
        let across = way.vector(name, "m²", e1.cross(e2));
        let added = given(way, [e1, e2], across);
        let added = way.part("what a triangle gives to its vertices", added);
        for k in corners {
            sums[k as usize] += added;
        }
    }
    let each = sums.into_iter().enumerate().map(|(i, sum)| {
        let sum = way.vector(format!("vertex {i}, the sum of its triangles'"), "m²", sum);
        let length = sum.length();
        let lone = way.is_at_most("a vertex has no triangle with an area", length, 0.0);
        let normal = if lone {
            way.part("the normal of such a vertex", of_none)
        } else {
            way.made("to normalise a vertex's sum", sum, sum / length)
        };
        way.vector(format!("vertex {i}, the same of length 1"), "", normal)
            .as_vec3()
    });
    each.collect()
}

/// A triangle's unit normal times its area.
fn weighted(way: &mut Way, [e1, e2]: [DVec3; 2], across: DVec3) -> DVec3 {
    way.part("the length of e₁", e1.length());
    way.part("the length of e₂", e2.length());
    way.part("the length of the third edge", (e2 - e1).length());
    let area = way.part("the triangle's area", 0.5 * across.length());
    let normal = way.part("the triangle's unit normal", across.normalize_or_zero());
    way.part("the triangle's weight", area) * normal
}

impl Explained for VertexNormals {
    const WAYS: &'static [fn(&Self, &mut Way) -> Vec<Vec3>] =
        &[Self::work, |asked, way| summed(asked, way, weighted)];

    fn work(&self, way: &mut Way) -> Vec<Vec3> {
        summed(self, way, |_, _, across| across)
    }
}

impl Explained for MeshHit {
    fn work(&self, way: &mut Way) -> Option<MeshHitAnswer> {
        let mut nearest = Nearest::default();
        if self.triangles.is_empty() {
            way.remark("The list is empty.");
        }
        for (id, triangle) in (0..).zip(&self.triangles) {
            let corners = [triangle.p0, triangle.p1, triangle.p2];
            let name = format!("triangle {id}");
            nearest.test(way, (&self.ray, self.within), (&name, id), corners);
        }
        let answer = nearest.answer(way)?;
        way.remark(format!("Of these, triangle {} is the nearest.", answer.id));
        Some(answer)
    }
}
