//! The crate `obvhs`: its tree of two children, and its compressed one of eight, both by the preset `medium_build`.
//!
//! The triangles are put into the order of the leaves, as its documentation advises.

use crate::racer::{MISS, Question, Search};
use glam::Vec3A;
use obvhs::bvh2::{Bvh2 as Tree, builder::build_bvh2_from_tris};
use obvhs::cwbvh::{CwBvh, builder::build_cwbvh_from_tris};
use obvhs::ray::{Ray, RayHit};
use obvhs::{BvhBuildParams, triangle::Triangle};
use raybook::shape::mesh::Mesh;
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
    /// Builds the tree.
    pub(crate) fn new(mesh: &Mesh) -> Self {
        let triangles = triangles(mesh);
        let params = BvhBuildParams::medium_build();
        let tree = build_bvh2_from_tris(&triangles, params, &mut Duration::default());
        let triangles = ordered(&triangles, &tree.primitive_indices);
        Self { tree, triangles }
    }
}

impl Wide {
    /// Builds the tree.
    pub(crate) fn new(mesh: &Mesh) -> Self {
        let triangles = triangles(mesh);
        let params = BvhBuildParams::medium_build();
        let tree = build_cwbvh_from_tris(&triangles, params, &mut Duration::default());
        let triangles = ordered(&triangles, &tree.primitive_indices);
        Self { tree, triangles }
    }
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
        }
    };
}

search!(Bvh2);
search!(Wide);

const _: () = assert!(MISS == f32::INFINITY, "obvhs says a miss in the same way");
