//! A triangle mesh: shared vertices, their attributes, and triangles that name three vertices each.
//!
//! ```
//! use raybook::prelude::*;
//!
//! // A square of two triangles, which share two of its four corners.
//! let corners = vec![Vec3::ZERO, Vec3::X, vec3(1.0, 1.0, 0.0), Vec3::Y];
//! let square = Mesh::new(corners, vec![[0, 1, 2], [0, 2, 3]], None, None)?;
//! assert_eq!((square.positions().len(), square.facets().len()), (4, 2));
//! assert_eq!(square.normals()[0], Dir3::Z); // averaged from the triangles
//! # Ok::<(), raybook::shape::mesh::MeshError>(())
//! ```

use crate::math::domain::{LARGEST, SMALLEST};
use crate::math::{aabb::Aabb, dir3::Dir3, interval::Interval, ray::Ray};
use crate::shape::attributes::{interpolate_normal, interpolate_texture, lift, vertex_normals};
use crate::shape::normal_map::NormalMap;
use crate::shape::triangle_watertight::{self, Shear};
use crate::shape::{Hit, Shape, Surface, triangle::Triangle};
use glam::{Vec2, Vec3};
use std::sync::Arc;

/// A surface of triangles.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    positions: Vec<Vec3>,
    normals: Vec<Dir3>,
    textures: Vec<Vec2>,
    triangles: Vec<[u32; 3]>,
    bounds: Aabb,
    bumps: Option<Arc<NormalMap>>,
}

/// Why numbers do not make a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum MeshError {
    /// A triangle names a vertex that does not exist.
    #[error(
        "triangle {triangle} uses vertex {index}, which is not there: the mesh has {vertices}, counted from 0"
    )]
    Index {
        /// Which triangle, from 0.
        triangle: usize,
        /// The index of the vertex.
        index: u32,
        /// How many vertices there are.
        vertices: usize,
    },
    /// A coordinate is NaN or infinite.
    #[error("vertex {vertex} has a coordinate that is not a finite number")]
    NotFinite {
        /// Which vertex, from 0.
        vertex: usize,
    },
    /// A coordinate is outside the domain.
    #[error(
        "vertex {vertex} is more than {LARGEST:e} m from 0 along an axis: make the mesh smaller"
    )]
    TooFar {
        /// Which vertex, from 0.
        vertex: usize,
    },
    /// The whole mesh is smaller than the domain allows.
    #[error("the mesh is less than {SMALLEST:e} m long along every axis: make it larger")]
    TooSmall,
    /// Attributes must be given for every vertex, or not at all.
    #[error("{attributes} {kind} were given for {vertices} vertices: one for each is needed")]
    Attributes {
        /// "normals" or "texture coordinates".
        kind: &'static str,
        /// How many were given.
        attributes: usize,
        /// How many vertices there are.
        vertices: usize,
    },
}

impl Mesh {
    /// A mesh of n vertices with positions in metres, n normals and n texture coordinates, and of triangles whose corners are
    /// counter-clockwise as seen from outside.
    ///
    /// If `normals` is `None`, they are averaged from the triangles ([`vertex_normals`]). If `textures` is `None`, all are 0.
    ///
    /// # Errors
    /// If an index is out of range, a position is not finite, the mesh is outside the [domain](crate::math::domain), or the
    /// number of normals or texture coordinates is not that of the vertices.
    pub fn new(
        positions: Vec<Vec3>,
        triangles: Vec<[u32; 3]>,
        normals: Option<Vec<Dir3>>,
        textures: Option<Vec<Vec2>>,
    ) -> Result<Self, MeshError> {
        let vertices = positions.len();
        for (triangle, corners) in triangles.iter().enumerate() {
            if let Some(&index) = corners.iter().find(|&&i| i as usize >= vertices) {
                return Err(MeshError::Index {
                    triangle,
                    index,
                    vertices,
                });
            }
        }
        if let Some(vertex) = positions.iter().position(|p| !p.is_finite()) {
            return Err(MeshError::NotFinite { vertex });
        }
        let is_far = |p: &Vec3| p.abs().max_element() > LARGEST;
        if let Some(vertex) = positions.iter().position(is_far) {
            return Err(MeshError::TooFar { vertex });
        }
        let bounds = Aabb::of(positions.iter().copied());
        let extent = bounds.size().max_element();
        if 0.0 < extent && extent < SMALLEST {
            return Err(MeshError::TooSmall);
        }
        let normals = normals.unwrap_or_else(|| vertex_normals(&positions, &triangles));
        let textures = textures.unwrap_or_else(|| vec![Vec2::ZERO; vertices]);
        for (kind, attributes) in [
            ("normals", normals.len()),
            ("texture coordinates", textures.len()),
        ] {
            if attributes != vertices {
                return Err(MeshError::Attributes {
                    kind,
                    attributes,
                    vertices,
                });
            }
        }
        Ok(Self {
            positions,
            normals,
            textures,
            triangles,
            bounds,
            bumps: None,
        })
    }

    /// The mesh with the bumps of a normal map on it, by its texture coordinates.
    #[must_use]
    pub fn with_bumps(self, map: Arc<NormalMap>) -> Self {
        Self {
            bumps: Some(map),
            ..self
        }
    }

    /// The vertices, in metres.
    pub fn positions(&self) -> &[Vec3] {
        &self.positions
    }

    /// One normal per vertex.
    pub fn normals(&self) -> &[Dir3] {
        &self.normals
    }

    /// One pair of texture coordinates per vertex.
    pub fn textures(&self) -> &[Vec2] {
        &self.textures
    }

    /// Three indices of vertices per triangle.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The smallest box that holds all vertices.
    pub fn bounds(&self) -> Aabb {
        self.bounds
    }

    /// The triangles as shapes of their own, in order: facet i has the id i.
    pub fn facets(&self) -> Vec<Facet> {
        let corners = |indices: &[u32; 3]| indices.map(|i| self.positions[i as usize]);
        let facet = |(indices, id)| Facet {
            corners: corners(indices),
            id,
        };
        self.triangles.iter().zip(0..).map(facet).collect()
    }

    /// The surface where a ray hit one of the facets: `hit.id` is the facet's id, `hit.uv` are the barycentric coordinates.
    ///
    /// # Panics
    /// If the mesh has no facet with this id.
    pub fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        let (Some(triangle), Some(corners)) =
            (self.triangle(hit.id), self.triangles.get(hit.id as usize))
        else {
            unreachable!(
                "hit {hit:?} is not of this mesh of {} triangles",
                self.triangles.len()
            )
        };
        let corners = corners.map(|i| i as usize);
        let (places, normals) = (
            corners.map(|i| self.positions[i]),
            corners.map(|i| self.normals[i]),
        );
        let textures = corners.map(|i| self.textures[i]);
        let texture = interpolate_texture(textures, hit.uv);
        let flat = triangle.surface(ray, hit);
        // The corners of walls and boxes often have one normal.
        let is_flat = normals[0] == normals[1] && normals[0] == normals[2];
        let (mut shading_normal, lift) = if is_flat {
            (normals[0], Vec3::ZERO)
        } else {
            let lift = lift(flat.position, places, normals, hit.uv);
            (interpolate_normal(normals, hit.uv), lift)
        };
        if let Some(bumps) = &self.bumps {
            let ([p0, p1, p2], [t0, t1, t2]) = (places, textures);
            let (edges, along) = ([p1 - p0, p2 - p0], [t1 - t0, t2 - t0]);
            shading_normal = bumps.tilt(shading_normal, edges, along, texture);
        }
        // `flat` has the texture coordinates (0, 0), (1, 0) and (0, 1): `share` is the ratio of the areas.
        let share = (textures[1] - textures[0]).perp_dot(textures[2] - textures[0]);
        Surface {
            shading_normal,
            texture,
            texture_per_metre: flat.texture_per_metre * share.abs().sqrt(),
            lift,
            ..flat
        }
    }

    fn triangle(&self, id: u32) -> Option<Triangle> {
        let [p0, p1, p2] = self
            .triangles
            .get(id as usize)?
            .map(|i| self.positions[i as usize]);
        Some(Triangle::new(p0, p1, p2))
    }
}

/// One triangle of a mesh; its hits carry its number.
///
/// A facet stores the corners, not p₀, e₁, e₂, because p₀ + e₁ is rounded. Neighbours must share p₁ to the last digit, so that no
/// ray slips through between them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facet {
    /// p₀, p₁, p₂.
    pub corners: [Vec3; 3],
    /// The facet's place in [`Mesh::triangles`].
    pub id: u32,
}

impl Facet {
    /// The facet as a [`Triangle`].
    pub fn triangle(&self) -> Triangle {
        let [p0, p1, p2] = self.corners;
        Triangle::new(p0, p1, p2)
    }
}

impl Shape for Facet {
    fn bounds(&self) -> Aabb {
        Aabb::of(self.corners)
    }

    #[inline]
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        Self::hit_by(ray)(self, within)
    }

    #[inline]
    fn hit_by(ray: &Ray) -> impl Fn(&Self, Interval) -> Option<Hit> {
        let shear = Shear::along(ray);
        move |facet, within| {
            let hit = triangle_watertight::hit_sheared(&facet.corners, ray, &shear, within)?;
            Some(Hit {
                id: facet.id,
                ..hit
            })
        }
    }

    #[inline]
    fn blocked_by(ray: &Ray) -> impl Fn(&Self, Interval) -> bool {
        let hit = Self::hit_by(ray);
        move |facet, within| hit(facet, within).is_some()
    }

    /// The flat surface; the smooth one is [`Mesh::surface`].
    fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        self.triangle().surface(ray, hit)
    }
}
