//! The crate `obvhs`: its tree of two children, and its compressed one of eight, by one of its presets.
//!
//! The triangles are put into the order of the leaves, as its documentation advises.

use crate::racer::{MISS, Question, Search};
use glam::Vec3A;
use obvhs::aabb::Aabb;
use obvhs::bvh2::{Bvh2 as Tree, builder::build_bvh2_from_tris};
use obvhs::cwbvh::{CwBvh, builder::build_cwbvh_from_tris};
use obvhs::ray::{Ray, RayHit};
use obvhs::{BvhBuildParams, triangle::Triangle};
use raybook::math::aabb;
use raybook::shape::mesh::Mesh;
use raybook_peers::sah::{Inside, Node};
use std::time::Duration;

/// Two children to a node.
pub(crate) struct Bvh2 {
    tree: Tree,
    triangles: Vec<Triangle>,
}

/// Eight children to a node, their boxes compressed.
pub(crate) struct Wide {
    tree: CwBvh,
    triangles: Vec<Triangle>,
}

fn triangles(mesh: &Mesh) -> Vec<Triangle> {
    let corner = |i: u32| Vec3A::from(mesh.positions()[i as usize]);
    let triangle = |&[a, b, c]: &[u32; 3]| Triangle {
        v0: corner(a),
        v1: corner(b),
        v2: corner(c),
    };
    mesh.triangles().iter().map(triangle).collect()
}

fn ordered(triangles: &[Triangle], order: &[u32]) -> Vec<Triangle> {
    order.iter().map(|&i| triangles[i as usize]).collect()
}

fn ray((ray, within): &Question) -> Ray {
    let (o, d) = (Vec3A::from(ray.origin), Vec3A::from(*ray.direction));
    Ray::new(o, d, within.min, within.max)
}

impl Bvh2 {
    /// Builds the tree by a preset.
    pub(crate) fn new(mesh: &Mesh, preset: BvhBuildParams) -> Self {
        let triangles = triangles(mesh);
        let tree = build_bvh2_from_tris(&triangles, preset, &mut Duration::default());
        let triangles = ordered(&triangles, &tree.primitive_indices);
        Self { tree, triangles }
    }
}

impl Wide {
    /// Builds the tree by a preset.
    pub(crate) fn new(mesh: &Mesh, preset: BvhBuildParams) -> Self {
        let triangles = triangles(mesh);
        let tree = build_cwbvh_from_tris(&triangles, preset, &mut Duration::default());
        let triangles = ordered(&triangles, &tree.primitive_indices);
        Self { tree, triangles }
    }
}

impl Bvh2 {
    /// The root and all nodes below it. What an optimised tree does not use any more may still be in its list.
    fn all_nodes(&self) -> Vec<Node> {
        let mut nodes = Vec::new();
        let mut waiting: Vec<usize> = self.tree.nodes.first().map(|_| 0).into_iter().collect();
        while let Some(i) = waiting.pop() {
            let node = &self.tree.nodes[i];
            let inside = if node.is_leaf() {
                Inside::Triangles(node.prim_count as usize)
            } else {
                let left = node.first_index as usize;
                waiting.extend([left, left + 1]);
                Inside::Children(2)
            };
            nodes.push((bounds(node.aabb()), inside));
        }
        nodes
    }
}

impl Wide {
    /// The root and all other nodes, with the boxes that rays meet: the compressed ones.
    fn all_nodes(&self) -> Vec<Node> {
        let nodes = &self.tree.nodes;
        let children = |i: usize| {
            let is_there = move |child: &usize| !nodes[i].is_child_empty(*child);
            (0..8).filter(is_there)
        };
        let inside = |i: usize, child: usize| {
            if nodes[i].is_leaf(child) {
                Inside::Triangles(nodes[i].child_primitives(child).1 as usize)
            } else {
                let node = nodes[i].child_node_index(child) as usize;
                Inside::Children(children(node).count())
            }
        };
        let root = nodes.first().map(|_| {
            let root = bounds(&self.tree.total_aabb);
            (root, Inside::Children(children(0).count()))
        });
        let below = (0..nodes.len()).flat_map(|i| {
            let node = move |child| (bounds(&nodes[i].child_aabb(child)), inside(i, child));
            children(i).map(node)
        });
        root.into_iter().chain(below).collect()
    }
}

fn bounds(of: &Aabb) -> aabb::Aabb {
    aabb::Aabb::new(of.min.into(), of.max.into())
}

/// Both trees are asked with the same words, but by no common trait.
macro_rules! search {
    ($racer:ident) => {
        impl Search for $racer {
            fn closest(&self, question: &Question) -> f32 {
                let mut hit = RayHit::none();
                self.tree.ray_traverse(ray(question), &mut hit, |ray, i| {
                    self.triangles[i].intersect(ray)
                });
                hit.t
            }

            fn any(&self, question: &Question) -> bool {
                let test = |ray: &Ray, i: usize| self.triangles[i].intersect(ray);
                !self.tree.ray_traverse_miss(ray(question), test)
            }

            fn nodes(&self, _mesh: &Mesh) -> Result<Vec<Node>, String> {
                Ok(self.all_nodes())
            }
        }
    };
}

search!(Bvh2);
search!(Wide);

const _: () = assert!(MISS == f32::INFINITY, "obvhs says a miss in the same way");
