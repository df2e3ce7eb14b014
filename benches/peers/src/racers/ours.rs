//! raybook's own accelerators.

use crate::racer::{MISS, Question, Search};
use raybook::accel::Accel;
use raybook::shape::mesh::Facet;

/// An accelerator over facets.
pub struct Ours<A>(pub A);

impl<A: Accel<Facet>> Search for Ours<A> {
    fn closest(&self, (ray, within): &Question) -> f32 {
        self.0.closest(ray, *within).map_or(MISS, |(_, hit)| hit.t)
    }

    fn any(&self, (ray, within): &Question) -> bool {
        self.0.any(ray, *within)
    }
}
