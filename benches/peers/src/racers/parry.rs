//! The crate `parry3d`: its triangle mesh.

use crate::racer::{MISS, Question, Search};
use glam::Vec3;
use parry3d::math::{Point, Vector};
use parry3d::partitioning::TraversalAction;
use parry3d::query::{Ray, RayCast};
use parry3d::shape::TriMesh;
use raybook::math::aabb::Aabb;
use raybook::shape::mesh::Mesh;
use raybook_peers::sah::{Inside, Node};

/// A triangle mesh with parry's tree.
pub(crate) struct Trimesh(TriMesh);

impl Trimesh {
    /// Builds it.
    ///
    /// # Errors
    /// If parry refuses the mesh.
    pub(crate) fn new(mesh: &Mesh) -> Result<Self, String> {
        let points = mesh.positions().iter().map(|p| Point::from(p.to_array()));
        TriMesh::new(points.collect(), mesh.triangles().to_vec())
            .map(Self)
            .map_err(|error| format!("parry3d: {error}"))
    }

    /// It knows no beginning but the origin.
    fn cast(&self, (ray, within): &Question) -> Option<f32> {
        let o = Point::from(ray.at(within.min).to_array());
        let d = Vector::from(ray.direction.to_array());
        let t = self
            .0
            .cast_local_ray(&Ray::new(o, d), within.max - within.min, false)?;
        Some(t + within.min)
    }
}

impl Search for Trimesh {
    fn closest(&self, question: &Question) -> f32 {
        self.cast(question).unwrap_or(MISS)
    }

    /// It knows no search for any hit.
    fn any(&self, question: &Question) -> bool {
        self.cast(question).is_some()
    }

    /// A leaf has one triangle. The root is not visited.
    fn nodes(&self, mesh: &Mesh) -> Result<Vec<Node>, String> {
        let mut nodes = vec![(mesh.bounds(), Inside::Children(2))];
        self.0.bvh().traverse(|node| {
            let [min, max] = [node.mins(), node.maxs()].map(|p| Vec3::new(p.x, p.y, p.z));
            let inside = if node.is_leaf() {
                Inside::Triangles(1)
            } else {
                Inside::Children(2)
            };
            nodes.push((Aabb::new(min, max), inside));
            TraversalAction::Continue
        });
        Ok(nodes)
    }
}
