//! Flat and smooth meshes: the same triangles, shaded as flat faces or as one round surface. A normal map must be added
//! afterwards.
//!
//! ```
//! use raybook::shape::teapot;
//!
//! let smooth = teapot::mesh(1);
//! let flat = smooth.flat();
//! assert_eq!(flat.triangles().len(), smooth.triangles().len());
//! assert_eq!(flat.positions().len(), 3 * flat.triangles().len()); // no vertex is shared
//! ```

use crate::math::dir3::Dir3;
use crate::shape::attributes::vertex_normals;
use crate::shape::mesh::Mesh;
use glam::{Vec2, Vec3};
use std::collections::HashMap;

impl Mesh {
    /// The mesh with flat shading, which shows the edges: each triangle has its own vertices, with the triangle's normal.
    #[must_use]
    pub fn flat(&self) -> Self {
        let corners = self.triangles().iter().flatten().map(|&i| i as usize);
        let positions: Vec<_> = corners.clone().map(|i| self.positions()[i]).collect();
        let textures = corners.map(|i| self.textures()[i]).collect();
        let triangles = (0..positions.len() as u32 / 3).map(|i| [0, 1, 2].map(|k| 3 * i + k));
        of_parts(positions, triangles.collect(), None, textures)
    }

    /// The mesh with smooth shading, as one round surface: vertices at the same place have the same normal, the mean of all
    /// triangles around the place ([`vertex_normals`]).
    #[must_use]
    pub fn smooth(&self) -> Self {
        let mut first = HashMap::new();
        let bits = |p: &Vec3| (*p + Vec3::ZERO).to_array().map(f32::to_bits); // −0 + 0 is 0
        let places: Vec<u32> = (0..)
            .zip(self.positions())
            .map(|(i, p)| *first.entry(bits(p)).or_insert(i))
            .collect();
        let by_place = |corners: &[u32; 3]| corners.map(|i| places[i as usize]);
        let triangles: Vec<_> = self.triangles().iter().map(by_place).collect();
        let normals = vertex_normals(self.positions(), &triangles);
        let normals: Vec<Dir3> = places
            .iter()
            .map(|&place| normals[place as usize])
            .collect();
        of_parts(
            self.positions().to_vec(),
            self.triangles().to_vec(),
            Some(normals),
            self.textures().to_vec(),
        )
    }
}

/// The mesh of parts that come from a valid mesh.
fn of_parts(
    positions: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
    normals: Option<Vec<Dir3>>,
    textures: Vec<Vec2>,
) -> Mesh {
    Mesh::new(positions, triangles, normals, Some(textures))
        .unwrap_or_else(|error| unreachable!("a mesh stays one: {error}"))
}
