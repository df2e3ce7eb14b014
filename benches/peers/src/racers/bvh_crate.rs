//! The crate `bvh`. It leaves the triangles to its user: here they are raybook's, by the method of Möller and Trumbore,
//! for its own test culls back faces and takes triangles below 10⁻⁷ m² for nothing.

use crate::racer::{MISS, Question, Search};
use bvh::aabb::{Aabb, Bounded};
use bvh::bounding_hierarchy::{BHShape, BoundingHierarchy};
use bvh::bvh::Bvh as Tree;
use bvh::ray::Ray;
use nalgebra::{Point3, Vector3};
use raybook::shape::mesh::Mesh;
use raybook::shape::{Shape, triangle::Triangle};

/// Its tree of two children.
pub(crate) struct Bvh {
    tree: Tree<f32, 3>,
    triangles: Vec<Placed>,
}

/// A triangle that knows its leaf.
struct Placed {
    triangle: Triangle,
    node: usize,
}

impl Bounded<f32, 3> for Placed {
    fn aabb(&self) -> Aabb<f32, 3> {
        let bounds = self.triangle.bounds();
        let [min, max] = [bounds.min, bounds.max].map(|p| Point3::from(p.to_array()));
        Aabb::with_bounds(min, max)
    }
}

impl BHShape<f32, 3> for Placed {
    fn set_bh_node_index(&mut self, node: usize) {
        self.node = node;
    }

    fn bh_node_index(&self) -> usize {
        self.node
    }
}

impl Bvh {
    /// Builds the tree.
    pub(crate) fn new(mesh: &Mesh) -> Self {
        let placed = |facet: &raybook::shape::mesh::Facet| Placed {
            triangle: facet.triangle(),
            node: 0,
        };
        let mut triangles: Vec<_> = mesh.facets().iter().map(placed).collect();
        let tree = Tree::build_par(&mut triangles);
        Self { tree, triangles }
    }
}

fn ray((ray, _): &Question) -> Ray<f32, 3> {
    let o = Point3::from(ray.origin.to_array());
    Ray::new(o, Vector3::from(ray.direction.to_array()))
}

impl Search for Bvh {
    /// The boxes come by distance, so the search ends with the first that lies beyond the nearest hit.
    fn closest(&self, question: &Question) -> f32 {
        let ray = ray(question);
        let mut within = question.1;
        let mut nearest = MISS;
        for placed in self.tree.nearest_traverse_iterator(&ray, &self.triangles) {
            let entry = ray.intersection_slice_for_aabb(&placed.aabb());
            if entry.is_some_and(|(entry, _)| entry > nearest) {
                break;
            }
            if let Some(hit) = placed.triangle.hit(&question.0, within) {
                within = within.before(hit.t);
                nearest = hit.t;
            }
        }
        nearest
    }

    fn any(&self, question: &Question) -> bool {
        let ray = ray(question);
        self.tree
            .traverse_iterator(&ray, &self.triangles)
            .any(|placed| placed.triangle.blocks(&question.0, question.1))
    }
}
