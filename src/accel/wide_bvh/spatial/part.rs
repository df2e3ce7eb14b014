//! The two parts of a triangle on either side of a plane.

use crate::accel::bvh::build::item::{Bounds, Item};
use crate::shape::mesh::Facet;
use glam::Vec3;

/// Boxes around the parts of an item below and above the plane at `at` along an axis; empty where there is no part.
///
/// They hold all of the part that the item's box holds: where the plane cuts an edge is computed in double precision, and
/// rounded outward.
pub(super) fn parts(item: &Item, facet: &Facet, axis: usize, at: f32) -> [Bounds; 2] {
    let [mut below, mut above] = [Bounds::EMPTY; 2];
    let [a, b, c] = facet.corners;
    for (p, q) in [(a, b), (b, c), (c, a)] {
        let (from, to) = (p[axis], q[axis]);
        if from <= at {
            below = below.union(&point(p, p));
        }
        if from >= at {
            above = above.union(&point(p, p));
        }
        if from.min(to) < at && at < from.max(to) {
            let part = f64::from(at - from) / f64::from(to - from);
            let met = p.as_dvec3().lerp(q.as_dvec3(), part).as_vec3();
            let met = point(met.map(f32::next_down), met.map(f32::next_up));
            below = below.union(&met);
            above = above.union(&met);
        }
    }
    below.max[axis] = at;
    above.min[axis] = at;
    [below, above].map(|part| part.intersection(&item.bounds))
}

fn point(min: Vec3, max: Vec3) -> Bounds {
    let (min, max) = (min.into(), max.into());
    Bounds { min, max }
}
