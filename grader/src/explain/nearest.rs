//! The nearest hit of triangles that are tested one after the other, as lists and searches in trees keep it.

use super::ch06_triangle;
use super::way::Way;
use glam::Vec3;
use raybook::math::{interval::Interval, ray::Ray};
use raybook_workbook::exercises::ch07_mesh::MeshHitAnswer;

/// The nearest hit among the triangles that were tested.
#[derive(Debug, Default)]
pub struct Nearest {
    hit: Option<(f64, u32)>,
    /// The number of triangles that were tested.
    pub tests: u32,
}

impl Nearest {
    /// Tests a triangle, which is called by `name`: "triangle 3".
    pub fn test(
        &mut self,
        way: &mut Way,
        (ray, within): (&Ray, Interval),
        (name, id): (&str, u32),
        corners: [Vec3; 3],
    ) {
        self.tests += 1;
        // Its own steps are those of `triangle_hit`.
        let hit = way.silently(|way| ch06_triangle::meets(way, ray, within, corners));
        let Some([t, ..]) = hit else {
            way.remark(format!("Not hit: {name}."));
            return;
        };
        let t = way.number(format!("{name} is hit at t ="), "m", t);
        if way.is_less("a hit is nearer than all before it", t, self.limit()) {
            self.hit = Some((t, id));
        }
    }

    /// What lies behind it does not count.
    pub fn limit(&self) -> f64 {
        self.hit.map_or(f64::INFINITY, |(t, _)| t)
    }

    /// The hit as an answer.
    pub fn answer(&self, way: &mut Way) -> Option<MeshHitAnswer> {
        let (t, id) = self.hit?;
        let t = way.part("t of the nearest", t) as f32;
        let id = way.part("the number of the nearest", f64::from(id)) as u32;
        Some(MeshHitAnswer { t, id })
    }
}
