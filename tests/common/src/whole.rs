//! Scenes and rays of whole numbers, at any scale: corners lie in planes of cells, and rays meet edges.

use glam::Vec3;
use proptest::prelude::*;
use raybook::accel::{Accel, list::List};
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::mesh::Facet;

/// Triangles, a ray, and by what their whole numbers were multiplied.
#[derive(Clone, Debug)]
pub struct Whole {
    /// The triangles.
    pub facets: Vec<Facet>,
    ray: Ray,
    scale: f32,
}

/// Up to forty triangles, often flat, doubled or without area.
pub fn whole() -> impl Strategy<Value = Whole> {
    let point = |half: i8| prop::array::uniform3(-half..=half);
    let corners = prop::collection::vec(prop::array::uniform3(point(3)), 0..40);
    let ray = (point(5), point(3)).prop_filter("two points", |(from, to)| from != to);
    (corners, ray, -6_i32..7).prop_map(|(corners, (from, to), scale)| {
        let scale = 10.0_f32.powi(scale);
        let point = |p: [i8; 3]| scale * Vec3::from_array(p.map(f32::from));
        let facet = |(id, c): (u32, &[[i8; 3]; 3])| Facet {
            corners: c.map(point),
            id,
        };
        let (from, to) = (point(from), point(to));
        Whole {
            facets: (0..).zip(&corners).map(facet).collect(),
            ray: Ray::new(from, Dir3::new_or(to - from, Dir3::X)),
            scale,
        }
    })
}

impl Whole {
    /// Whether a structure over the triangles finds what the list finds.
    pub fn agrees(&self, structure: &impl Accel<Facet>) -> Result<(), TestCaseError> {
        let hit = |hit: Option<(&Facet, raybook::shape::Hit)>| hit.map(|(_, hit)| hit.t);
        let ahead = Interval::AHEAD;
        let expected = hit(List::new(self.facets.clone()).closest(&self.ray, ahead));
        let found = hit(structure.closest(&self.ray, ahead));
        let close = match (expected, found) {
            (Some(a), Some(b)) => (a - b).abs() <= 32.0 * f32::EPSILON * 10.0 * self.scale,
            (a, b) => a == b,
        };
        prop_assert!(close, "{:?} and not {:?}", found, expected);
        prop_assert_eq!(structure.any(&self.ray, ahead), found.is_some());
        Ok(())
    }
}
