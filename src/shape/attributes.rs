//! What a mesh knows at its vertices, and how it is found in between.

use crate::math::dir3::Dir3;
use glam::{Vec2, Vec3};

// ANCHOR: vertex_normals
/// One normal per vertex: the sum of e₁ × e₂ over the triangles around it, normalised (after Gouraud 1971).
///
/// |e₁ × e₂| is twice a triangle's area, so large triangles weigh more. That is what they deserve: a triangle without
/// area adds nothing, where its normal would be NaN, and cutting one in two, from this vertex to the side opposite,
/// changes nothing here. A vertex whose triangles cancel out, or that has none, gets +y.
///
/// # Panics
/// If a triangle names a vertex that does not exist.
pub fn vertex_normals(positions: &[Vec3], triangles: &[[u32; 3]]) -> Vec<Dir3> {
    let mut sums = vec![Vec3::ZERO; positions.len()];
    for corners in triangles {
        let [p0, p1, p2] = corners.map(|i| positions[i as usize]);
        let twice_area = (p1 - p0).cross(p2 - p0);
        for &i in corners {
            sums[i as usize] += twice_area;
        }
    }
    sums.into_iter()
        .map(|sum| Dir3::new_or(sum, Dir3::Y))
        .collect()
}
// ANCHOR_END: vertex_normals

// ANCHOR: interpolate_normal
/// The normal inside a triangle: (1 − b₁ − b₂)·n₀ + b₁·n₁ + b₂·n₂, normalised again, for it is shorter than 1 between
/// corners whose normals differ (Phong 1975). Where the three cancel out, n₀.
pub fn interpolate_normal(normals: [Dir3; 3], b: Vec2) -> Dir3 {
    let [n0, n1, n2] = normals;
    Dir3::new_or((1.0 - b.x - b.y) * *n0 + b.x * *n1 + b.y * *n2, n0)
}
// ANCHOR_END: interpolate_normal

// ANCHOR: lift
/// From a point p of a triangle to the round surface: −Σ bᵢ min(0, (p − pᵢ)·nᵢ) nᵢ.
///
/// At each corner the round surface has the plane through pᵢ that is perpendicular to nᵢ. Where p is below the plane it is lifted
/// onto it, and the three lifted points are weighted as the corners are (Hanika 2021). On a flat mesh, and in hollows, it is 0.
pub fn lift(p: Vec3, corners: [Vec3; 3], normals: [Dir3; 3], b: Vec2) -> Vec3 {
    let shares = [1.0 - b.x - b.y, b.x, b.y];
    let below = |i: usize| (p - corners[i]).dot(*normals[i]).min(0.0);
    let lifted = |i: usize| *normals[i] * (-shares[i] * below(i));
    lifted(0) + lifted(1) + lifted(2)
}
// ANCHOR_END: lift

// ANCHOR: interpolate_texture
/// The texture coordinates inside a triangle: (1 − b₁ − b₂)·t₀ + b₁·t₁ + b₂·t₂.
pub fn interpolate_texture(textures: [Vec2; 3], b: Vec2) -> Vec2 {
    let [t0, t1, t2] = textures;
    (1.0 - b.x - b.y) * t0 + b.x * t1 + b.y * t2
}
// ANCHOR_END: interpolate_texture
