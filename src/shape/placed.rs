//! A mesh somewhere else: as large, turned and placed as one wants it.

use crate::math::dir3::Dir3;
use crate::shape::mesh::Mesh;
use glam::{Mat3, Vec3};

/// The mesh with its vertices at `to` + `scale` · `turn` · p, without texture coordinates.
///
/// # Panics
/// If a vertex is no longer finite.
pub fn placed(mesh: &Mesh, scale: f32, turn: Mat3, to: Vec3) -> Mesh {
    let positions = mesh.positions().iter();
    let positions = positions.map(|&p| to + scale * (turn * p)).collect();
    let normals = mesh.normals().iter();
    let normals = normals.map(|&n| Dir3::new_or(turn * *n, n)).collect();
    let triangles = mesh.triangles().to_vec();
    Mesh::new(positions, triangles, Some(normals), None)
        .unwrap_or_else(|error| panic!("the mesh cannot be placed at {to}: {error}"))
}
