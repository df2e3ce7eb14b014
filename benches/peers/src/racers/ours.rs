//! raybook's own accelerators.

use crate::meshes::Scene;
use crate::racer::{MISS, Question, Racer, Search};
use raybook::accel::{
    Accel, Meshed,
    bvh::{Bvh, build::Method},
    wide_bvh::WideBvh,
};
use raybook::math::ray::Ray;
use raybook::shape::{
    Shape,
    instance::Instance,
    mesh::{Facet, Mesh},
};
use raybook_peers::{sah::Node, trees};
use std::sync::Arc;

/// An accelerator over facets.
pub(crate) struct Ours<A>(pub A);

impl<A: Accel<Facet>> Search for Ours<A> {
    fn closest(&self, (ray, within): &Question) -> f32 {
        self.0.closest(ray, *within).map_or(MISS, |(_, hit)| hit.t)
    }

    fn any(&self, (ray, within): &Question) -> bool {
        self.0.any(ray, *within)
    }
}

/// The tree of two children.
pub(crate) struct Binary(pub Bvh<Facet>);

impl Search for Binary {
    fn closest(&self, (ray, within): &Question) -> f32 {
        self.0.closest(ray, *within).map_or(MISS, |(_, hit)| hit.t)
    }

    fn any(&self, (ray, within): &Question) -> bool {
        self.0.any(ray, *within)
    }

    fn nodes(&self, _mesh: &Mesh) -> Result<Vec<Node>, String> {
        Ok(trees::binary(&self.0))
    }
}

/// The wide tree, which can also be asked in batches.
pub(crate) struct Wide(pub WideBvh);

impl Search for Wide {
    fn closest(&self, (ray, within): &Question) -> f32 {
        self.0.closest(ray, *within).map_or(MISS, |(_, hit)| hit.t)
    }

    fn any(&self, (ray, within): &Question) -> bool {
        self.0.any(ray, *within)
    }

    /// All questions of a batch have one interval. Copying the rays counts too.
    fn closest_many(&self, questions: &[Question], answers: &mut Vec<f32>) -> bool {
        let Some((_, within)) = questions.first() else {
            return true;
        };
        let rays: Vec<Ray> = questions.iter().map(|(ray, _)| *ray).collect();
        let hits = self.0.closest_many(&rays, *within);
        answers.extend(hits.iter().map(|hit| hit.map_or(MISS, |(_, hit)| hit.t)));
        true
    }

    fn nodes(&self, mesh: &Mesh) -> Result<Vec<Node>, String> {
        Ok(trees::wide(&self.0, mesh.bounds()))
    }
}

/// A tree of two children over instances, each of the same wide tree.
struct Instances(Bvh<Instance>);

/// Builds it.
///
/// # Errors
/// If the scene is no forest.
pub(crate) fn build_instances(scene: &Scene, _threads: usize) -> Result<Box<dyn Racer>, String> {
    let forest = scene.forest.as_ref().ok_or("this scene has no instances")?;
    let tree: Arc<dyn Shape> = Arc::new(Meshed::new(forest.tree.clone(), WideBvh::new));
    // A leaf holds one instance: to search it is dearer than any number of boxes.
    let top = Bvh::with_leaves(forest.instances(&tree), Method::Fine, 1);
    Ok(Box::new(Instances(top)))
}

impl Search for Instances {
    fn closest(&self, (ray, within): &Question) -> f32 {
        self.0.closest(ray, *within).map_or(MISS, |(_, hit)| hit.t)
    }

    fn any(&self, (ray, within): &Question) -> bool {
        self.0.any(ray, *within)
    }
}
