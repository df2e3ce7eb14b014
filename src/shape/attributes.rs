//! The attributes of a mesh's vertices, and their interpolation inside triangles.
//!
//! ```
//! use raybook::prelude::*;
//! use raybook::shape::attributes::interpolate_normal;
//!
//! let normal = interpolate_normal([Dir3::X, Dir3::Y, Dir3::Z], vec2(0.5, 0.0));
//! assert!((normal.length() - 1.0).abs() < 1e-6); // the mean of x and y would be 0.7 long
//! assert_eq!(normal.x, normal.y);
//! ```

use crate::math::dir3::Dir3;
use glam::{Vec2, Vec3};

// ANCHOR: vertex_normals
/// One normal per vertex: the sum of e₁ × e₂ over the triangles around the vertex, normalised (after Gouraud 1971).
///
/// |e₁ × e₂| is twice a triangle's area, so large triangles have more weight. This has two advantages. A triangle without
/// area adds 0, although its normal would be NaN. And if a triangle is cut in two, from the vertex to the opposite side, the
/// normal at this vertex stays the same. A vertex whose sum is 0, or that has no triangle, gets +y.
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
/// The normal inside a triangle at the barycentric coordinates b: (1 − b₁ − b₂)·n₀ + b₁·n₁ + b₂·n₂, normalised, because between
/// corners with different normals the sum is shorter than 1 (Phong 1975). n₀ if the sum is 0.
pub fn interpolate_normal(normals: [Dir3; 3], b: Vec2) -> Dir3 {
    let [n0, n1, n2] = normals;
    Dir3::new_or((1.0 - b.x - b.y) * *n0 + b.x * *n1 + b.y * *n2, n0)
}
// ANCHOR_END: interpolate_normal

// ANCHOR: lift
/// The vector from a point p of a triangle to the round surface that the normals describe: −Σ bᵢ min(0, (p − pᵢ)·nᵢ) nᵢ, in
/// metres, with b₀ = 1 − b₁ − b₂.
///
/// At corner pᵢ, the round surface has a tangent plane, perpendicular to nᵢ. If p is below this plane, p is lifted onto the
/// plane. The three lifts are averaged with the barycentric weights (Hanika 2021). On a flat mesh and in hollows the result is 0.
pub fn lift(p: Vec3, corners: [Vec3; 3], normals: [Dir3; 3], b: Vec2) -> Vec3 {
    let shares = [1.0 - b.x - b.y, b.x, b.y];
    let below = |i: usize| (p - corners[i]).dot(*normals[i]).min(0.0);
    let lifted = |i: usize| *normals[i] * (-shares[i] * below(i));
    lifted(0) + lifted(1) + lifted(2)
}
// ANCHOR_END: lift

// ANCHOR: interpolate_texture
/// The texture coordinates inside a triangle at the barycentric coordinates b: (1 − b₁ − b₂)·t₀ + b₁·t₁ + b₂·t₂.
pub fn interpolate_texture(textures: [Vec2; 3], b: Vec2) -> Vec2 {
    let [t0, t1, t2] = textures;
    (1.0 - b.x - b.y) * t0 + b.x * t1 + b.y * t2
}
// ANCHOR_END: interpolate_texture
