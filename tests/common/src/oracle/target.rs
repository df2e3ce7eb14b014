//! What rays are shot at: a shape of raybook, and what Embree is given in its place.

use crate::oracle::judge::Answer;
use crate::oracle::meeting::Meeting;
use crate::oracle::meshes;
use glam::Vec3;
use raybook::accel::{Meshed, list::List};
use raybook::math::{aabb::Aabb, basis::Basis, dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::mesh::{Mesh, MeshError};
use raybook::shape::{Shape, cuboid::Cuboid, plane::Plane, sphere::Sphere, triangle::Triangle};
use std::fmt;

/// A plane's stand-in for Embree is a square from −8 m to 8 m around the plane's point nearest to the world's origin.
const PLANE_HALF: f32 = 8.0;

/// Rays at a plane start at most 3 m from that point and end after this many metres: never at the square's edge.
pub const PLANE_FAR: f32 = 4.0;

/// What Embree is given.
#[derive(Clone, Debug)]
pub enum Solid {
    /// Triangles.
    Triangles(Mesh),
    /// A sphere.
    Sphere(Sphere),
}

/// A shape, in both worlds.
pub struct Target {
    /// The shape in words and numbers, as recordings have it: `sphere 0 0 0 1`.
    pub words: String,
    /// The shape as raybook knows it.
    pub shape: Box<dyn Shape>,
    /// The shape as Embree is told.
    pub solid: Solid,
    /// Whether the triangles are the shape itself, not a stand-in, so that their numbers and barycentrics must agree too.
    pub numbered: bool,
    /// No ray looks farther.
    pub far: f32,
}

impl fmt::Debug for Target {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_tuple("Target").field(&self.words).finish()
    }
}

impl Target {
    /// A sphere.
    pub fn sphere(sphere: Sphere) -> Self {
        Self {
            words: format!("sphere {} {}", spaced(sphere.center), sphere.radius),
            shape: Box::new(sphere),
            solid: Solid::Sphere(sphere),
            numbered: false,
            far: f32::INFINITY,
        }
    }

    /// One triangle.
    ///
    /// # Errors
    /// If a coordinate is not finite.
    pub fn triangle(corners: [Vec3; 3]) -> Result<Self, MeshError> {
        let [p0, p1, p2] = corners;
        Ok(Self {
            words: format!("triangle {} {} {}", spaced(p0), spaced(p1), spaced(p2)),
            shape: Box::new(Triangle::new(p0, p1, p2)),
            solid: Solid::Triangles(Mesh::new(corners.to_vec(), vec![[0, 1, 2]], None, None)?),
            numbered: true,
            far: f32::INFINITY,
        })
    }

    /// A mesh made by [`meshes::named`], searched triangle by triangle; `None` if there is no such kind.
    pub fn mesh(kind: &str, triangles: u32) -> Option<Self> {
        let mesh = meshes::named(kind, triangles)?;
        Some(Self {
            words: format!("mesh {kind} {triangles}"),
            shape: Box::new(Meshed::new(mesh.clone(), List::new)),
            solid: Solid::Triangles(mesh),
            numbered: true,
            far: f32::INFINITY,
        })
    }

    /// A plane; to Embree, two triangles.
    ///
    /// # Errors
    /// If a coordinate is not finite.
    pub fn plane(point: Vec3, normal: Dir3) -> Result<Self, MeshError> {
        let plane = Plane::through(point, normal);
        let Basis { x, y, z } = Basis::around(normal);
        let at = |i: f32, j: f32| plane.offset * *z + PLANE_HALF * (i * *x + j * *y);
        let corners = vec![at(-1.0, -1.0), at(1.0, -1.0), at(1.0, 1.0), at(-1.0, 1.0)];
        Ok(Self {
            words: format!("plane {} {}", spaced(point), spaced(*normal)),
            shape: Box::new(plane),
            solid: Solid::Triangles(Mesh::new(corners, vec![[0, 1, 2], [0, 2, 3]], None, None)?),
            numbered: false,
            far: PLANE_FAR,
        })
    }

    /// A box; to Embree, twelve triangles.
    ///
    /// # Errors
    /// If a coordinate is not finite.
    pub fn cuboid(bounds: Aabb) -> Result<Self, MeshError> {
        Ok(Self {
            words: format!("cuboid {} {}", spaced(bounds.min), spaced(bounds.max)),
            shape: Box::new(Cuboid { bounds }),
            solid: Solid::Triangles(meshes::around(bounds)?),
            numbered: false,
            far: f32::INFINITY,
        })
    }

    /// What raybook answers.
    pub fn ask(&self, ray: &Ray, within: Interval) -> Option<Answer> {
        let hit = self.shape.hit(ray, within)?;
        Some(Answer {
            t: hit.t,
            id: hit.id,
            uv: hit.uv,
            normal: *self.shape.surface(ray, &hit).normal,
        })
    }

    /// The exact meetings that may explain an answer: with the triangle it names, or with all that stand in for the shape.
    pub fn meetings(&self, ray: &Ray, answer: &Answer) -> Vec<Meeting> {
        match &self.solid {
            Solid::Sphere(sphere) => vec![Meeting::with_sphere(sphere, ray)],
            Solid::Triangles(mesh) if self.numbered => corners(mesh, answer.id)
                .map(|corners| Meeting::with_triangle(corners, ray))
                .into_iter()
                .collect(),
            Solid::Triangles(mesh) => (0..)
                .map_while(|id| Some(Meeting::with_triangle(corners(mesh, id)?, ray)))
                .collect(),
        }
    }

    /// The exact meeting with the triangle (or the sphere) that Embree says it hit; `None` if there is no such triangle.
    pub fn meeting(&self, ray: &Ray, embree: &Answer) -> Option<Meeting> {
        match &self.solid {
            Solid::Sphere(sphere) => Some(Meeting::with_sphere(sphere, ray)),
            Solid::Triangles(mesh) => Some(Meeting::with_triangle(corners(mesh, embree.id)?, ray)),
        }
    }
}

/// The corners of a triangle of a mesh.
pub fn corners(mesh: &Mesh, id: u32) -> Option<[Vec3; 3]> {
    let corners = mesh.triangles().get(id as usize)?;
    Some(corners.map(|i| mesh.positions()[i as usize]))
}

/// Three numbers, each as short as it can be read back exactly.
pub fn spaced(v: Vec3) -> String {
    format!("{} {} {}", v.x, v.y, v.z)
}
