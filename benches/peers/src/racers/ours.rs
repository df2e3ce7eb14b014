//! raybook's own accelerators.

use crate::racer::{MISS, Question, Search};
use raybook::accel::{Accel, wide_bvh::WideBvh};
use raybook::math::ray::Ray;
use raybook::shape::mesh::Facet;

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
}
