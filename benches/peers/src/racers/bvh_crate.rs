//! The crate `bvh`. It leaves the triangles to its user: here they are raybook's, by the method of Möller and Trumbore,
//! for its own test culls back faces and takes triangles below 10⁻⁷ m² for nothing.

use crate::racer::{MISS, Question, Search};
use bvh::aabb::{Aabb, Bounded};
use bvh::bounding_hierarchy::{BHShape, BoundingHierarchy};
use bvh::bvh::{Bvh as Tree, BvhNode};
use bvh::ray::Ray;
use glam::Vec3;
use nalgebra::{Point3, Vector3};
use raybook::math::aabb;
use raybook::shape::mesh::Mesh;
use raybook::shape::{Shape, triangle::Triangle};
use raybook_peers::sah::{Inside, Node};

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

    /// A node knows its children's boxes, and a leaf has one triangle.
    fn nodes(&self, mesh: &Mesh) -> Result<Vec<Node>, String> {
        let nodes = &self.tree.nodes;
        let inside = |i: usize| match nodes[i] {
            BvhNode::Leaf { .. } => Inside::Triangles(1),
            BvhNode::Node { .. } => Inside::Children(2),
        };
        let root = nodes.first().map(|_| (mesh.bounds(), inside(0)));
        let below = nodes.iter().flat_map(|node| match node {
            BvhNode::Leaf { .. } => Vec::new(),
            BvhNode::Node {
                child_l_index: left,
                child_l_aabb: of_left,
                child_r_index: right,
                child_r_aabb: of_right,
                ..
            } => vec![
                (bounds(of_left), inside(*left)),
                (bounds(of_right), inside(*right)),
            ],
        });
        Ok(root.into_iter().chain(below).collect())
    }
}

fn bounds(of: &Aabb<f32, 3>) -> aabb::Aabb {
    let [min, max] = [of.min, of.max].map(|p| Vec3::new(p.x, p.y, p.z));
    aabb::Aabb::new(min, max)
}
