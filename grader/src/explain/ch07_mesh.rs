//! Chapter 7: what lies between a triangle's corners, normals at vertices, and the nearest triangle of a list.

use super::Explained;
use super::ch06_triangle;
use super::way::Way;
use glam::{DVec2, DVec3, Vec2, Vec3};
use raybook_workbook::exercises::ch07_mesh::{
    InterpolateNormal, InterpolateTexture, MeshHit, MeshHitAnswer, VertexNormals,
};

/// The weights of the three corners.
fn weights(way: &mut Way, b: Vec2) -> [f64; 3] {
    let b = b.as_dvec2();
    let b0 = way.number("b₀ = 1 − b₁ − b₂", "", 1.0 - b.x - b.y);
    [b0, b.x, b.y]
}

impl Explained for InterpolateNormal {
    fn work(&self, way: &mut Way) -> Vec3 {
        let b = weights(way, self.b);
        let normals = [self.n0, self.n1, self.n2].map(|n| n.as_dvec3());
        let sum = b[0] * normals[0] + b[1] * normals[1] + b[2] * normals[2];
        let sum: DVec3 = way.vector("b₀n₀ + b₁n₁ + b₂n₂", "", sum);
        let length = way.number("its length", "", sum.length());
        let normal = if length > 0.0 {
            sum / length
        } else {
            normals[0]
        };
        way.vector("the same of length 1", "", normal).as_vec3()
    }
}

impl Explained for InterpolateTexture {
    fn work(&self, way: &mut Way) -> Vec2 {
        let b = weights(way, self.b);
        let [t0, t1, t2]: [DVec2; 3] = [self.t0, self.t1, self.t2].map(Vec2::as_dvec2);
        way.pair("b₀t₀ + b₁t₁ + b₂t₂", "", b[0] * t0 + b[1] * t1 + b[2] * t2)
            .as_vec2()
    }
}

impl Explained for VertexNormals {
    fn work(&self, way: &mut Way) -> Vec<Vec3> {
        let mut sums = vec![DVec3::ZERO; self.positions.len()];
        for (i, triangle) in self.triangles.iter().enumerate() {
            let corners = [triangle.a, triangle.b, triangle.c];
            let [p0, p1, p2] = corners.map(|k| self.positions[k as usize].as_dvec3());
            let name = format!("triangle {i}, e₁ × e₂: its normal, twice as long as its area");
            let across = way.vector(name, "m²", (p1 - p0).cross(p2 - p0));
            for k in corners {
                sums[k as usize] += across;
            }
        }
        let each = sums.into_iter().enumerate().map(|(i, sum)| {
            let sum = way.vector(format!("vertex {i}, the sum of its triangles'"), "m²", sum);
            let normal = sum.try_normalize().unwrap_or(DVec3::Y);
            way.vector(format!("vertex {i}, the same of length 1"), "", normal)
                .as_vec3()
        });
        each.collect()
    }
}

impl Explained for MeshHit {
    fn work(&self, way: &mut Way) -> Option<MeshHitAnswer> {
        let mut nearest: Option<(f64, u32)> = None;
        if self.triangles.is_empty() {
            way.remark("The list is empty.");
        }
        for (id, triangle) in (0..).zip(&self.triangles) {
            let corners = [triangle.p0, triangle.p1, triangle.p2];
            // Its own steps are those of `triangle_hit`.
            let hit =
                way.silently(|way| ch06_triangle::meets(way, &self.ray, self.within, corners));
            let Some([t, ..]) = hit else {
                way.remark(format!("Triangle {id} is not hit."));
                continue;
            };
            way.number(format!("triangle {id} is hit at t ="), "m", t);
            if nearest.is_none_or(|(before, _)| t < before) {
                nearest = Some((t, id));
            }
        }
        let (t, id) = nearest?;
        way.remark(format!("Of these, triangle {id} is the nearest."));
        Some(MeshHitAnswer { t: t as f32, id })
    }
}
