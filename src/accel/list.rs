//! The linear search: every ray tests every shape.
//!
//! ```
//! use raybook::prelude::*;
//!
//! let ball = |z| Sphere::new(vec3(0.0, 0.0, z), 1.0);
//! let list = List::new(vec![ball(9.0), ball(5.0), ball(7.0)]);
//! let (nearest, hit) = list.closest(&Ray::new(Vec3::ZERO, Dir3::Z), Interval::AHEAD).expect("three in the way");
//! assert_eq!((nearest.center.z, hit.t), (5.0, 4.0));
//! ```

use crate::accel::{Accel, Count};
use crate::math::{interval::Interval, ray::Ray};
use crate::shape::{Hit, Shape};

/// Shapes in no special order, all of which are tested: simple enough to be right by reading, and the reference that every
/// faster structure is tested against.
#[derive(Clone, Debug)]
pub struct List<S> {
    shapes: Vec<S>,
}

impl<S: Shape> List<S> {
    /// A list of shapes.
    pub fn new(shapes: Vec<S>) -> Self {
        Self { shapes }
    }

    /// The nearest hit of all; the interval ends at it, for what is searched next.
    pub(super) fn closest_before(
        &self,
        ray: &Ray,
        within: &mut Interval,
        count: &mut impl Count,
    ) -> Option<(&S, Hit)> {
        let closest = self.closest_counted(ray, *within, count);
        if let Some((_, hit)) = closest {
            *within = within.before(hit.t);
        }
        closest
    }
}

impl<S: Shape> Accel<S> for List<S> {
    // ANCHOR: mesh_hit
    /// Tests all shapes; each hit shortens the interval for the shapes that follow.
    fn closest_counted(
        &self,
        ray: &Ray,
        mut within: Interval,
        count: &mut impl Count,
    ) -> Option<(&S, Hit)> {
        let (hit_by_ray, mut closest) = (S::hit_by(ray), None);
        for shape in &self.shapes {
            count.tested_shape();
            if let Some(hit) = hit_by_ray(shape, within) {
                within = within.before(hit.t);
                closest = Some((shape, hit));
            }
        }
        closest
    }
    // ANCHOR_END: mesh_hit

    fn any(&self, ray: &Ray, within: Interval) -> bool {
        let blocks = S::blocked_by(ray);
        self.shapes.iter().any(|shape| blocks(shape, within))
    }
}
