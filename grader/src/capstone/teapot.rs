//! The teapot of the picture: a mesh, its normals, and where on it rays arrive.

use super::functions::Functions;
use super::nearest::Reach;
use glam::{Vec2, Vec3, vec2, vec3};
use raybook::math::{aabb::Aabb, dir3::Dir3, slab};
use raybook::shape::{attributes, teapot};
use raybook_workbook::exercises::ch07_mesh::{
    Corners, Indices, InterpolateNormal, MeshHit, VertexNormals,
};
use std::io;

/// Cells along each side of its 32 patches: a question holds all triangles, in words.
const CELLS: usize = 2;
/// How high it is, in metres.
const HEIGHT: f32 = 0.6;
/// The middle of its foot, in metres.
const FOOT: Vec3 = vec3(2.1, 0.0, 2.3);

/// The teapot.
pub(super) struct Teapot {
    positions: Vec<Vec3>,
    triangles: Vec<Indices>,
    corners: Vec<Corners>,
    bounds: Aabb,
    /// The normals at its vertices, once they were asked for.
    normals: Vec<Dir3>,
}

impl Teapot {
    /// As it stands in the scene.
    pub(super) fn new() -> Self {
        let mesh = teapot::mesh(CELLS);
        let bounds = mesh.bounds();
        let foot = bounds.center().with_y(bounds.min.y);
        let scale = HEIGHT / bounds.size().y;
        let place = |p: &Vec3| FOOT + scale * (*p - foot);
        let positions: Vec<_> = mesh.positions().iter().map(place).collect();
        let corner = |i: u32| positions[i as usize];
        let corners = mesh.triangles().iter().map(|&[a, b, c]| Corners {
            p0: corner(a),
            p1: corner(b),
            p2: corner(c),
        });
        let triangles = mesh.triangles().iter();
        Self {
            corners: corners.collect(),
            triangles: triangles.map(|&[a, b, c]| Indices { a, b, c }).collect(),
            bounds: Aabb::of(positions.iter().copied()),
            normals: Vec::new(),
            positions,
        }
    }

    /// Where rays hit it, and which of its triangles. A ray that misses its box is not asked about.
    pub(super) fn hits(
        &self,
        functions: &mut Functions<'_>,
        reaches: &[Reach],
    ) -> io::Result<Vec<Option<(f32, u32)>>> {
        let meets = |(ray, within): &Reach| slab::clip(&self.bounds, ray, *within).is_some();
        let (near, questions): (Vec<_>, Vec<_>) = reaches
            .iter()
            .enumerate()
            .filter(|(_, reach)| meets(reach))
            .map(|(i, &(ray, within))| {
                let triangles = self.corners.clone();
                let question = MeshHit {
                    ray,
                    within,
                    triangles,
                };
                (i, question)
            })
            .unzip();
        let mut hits = vec![None; reaches.len()];
        for (i, answer) in near.into_iter().zip(functions.ask(&questions)?) {
            hits[i] = answer.flatten().map(|hit| (hit.t, hit.id));
        }
        Ok(hits)
    }

    /// The corners of a triangle, if there is one of this number.
    pub(super) fn corners(&self, number: u32) -> Option<[Vec3; 3]> {
        let corners = self.corners.get(number as usize)?;
        Some([corners.p0, corners.p1, corners.p2])
    }

    /// The question of the smooth normal at a point of a triangle, and the point on the smooth surface above: there, no flat
    /// neighbour is in the light's way.
    pub(super) fn smooth(
        &mut self,
        functions: &mut Functions<'_>,
        number: u32,
        point: Vec3,
    ) -> io::Result<Option<(InterpolateNormal, Vec3)>> {
        let Some(corners) = self.corners(number) else {
            return Ok(None);
        };
        if self.normals.is_empty() {
            self.normals = self.ask_normals(functions)?;
        }
        let Indices { a, b, c } = self.triangles[number as usize];
        let [n0, n1, n2] = [a, b, c].map(|i| self.normals[i as usize]);
        let b = weights(corners, point);
        let lifted = point + attributes::lift(point, corners, [n0, n1, n2], b);
        Ok(Some((InterpolateNormal { n0, n1, n2, b }, lifted)))
    }

    /// The normals at the vertices: the course's where a list of another length comes.
    fn ask_normals(&self, functions: &mut Functions<'_>) -> io::Result<Vec<Dir3>> {
        let question = VertexNormals {
            positions: self.positions.clone(),
            triangles: self.triangles.clone(),
        };
        let mut normals = functions
            .ask_or_answer(std::slice::from_ref(&question))?
            .remove(0);
        if normals.len() != self.positions.len() {
            normals = Functions::of_course(7)
                .ask_or_answer(&[question])?
                .remove(0);
        }
        let unit = |n: Vec3| Dir3::new_or(n, Dir3::Y);
        Ok(normals.into_iter().map(unit).collect())
    }
}

/// The weights of the second and the third corner at a point of a triangle.
fn weights([p0, p1, p2]: [Vec3; 3], p: Vec3) -> Vec2 {
    let (e1, e2, to) = (p1 - p0, p2 - p0, p - p0);
    let n = e1.cross(e2);
    let b = vec2(to.cross(e2).dot(n), e1.cross(to).dot(n)) / n.length_squared();
    if b.is_finite() {
        b.clamp(Vec2::ZERO, Vec2::ONE)
    } else {
        Vec2::ZERO
    }
}
