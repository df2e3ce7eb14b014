//! Chapter 16: `sample_rect`, `sample_sphere_light`, `visible_fraction`.

mod chosen;
mod cone;
mod sample_rect;
mod sample_sphere_light;
mod visible_fraction;

use crate::examine::Examiner;
use raybook_workbook::exercises::ch16_soft_shadows::{
    SampleRect, SampleSphereLight, VisibleFraction,
};
use glam::{Vec2, vec2};

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&SampleRect, &SampleSphereLight, &VisibleFraction];

/// The middles of the cells of an n × n lattice.
fn lattice(n: u32) -> impl Iterator<Item = Vec2> {
    (0..n * n).map(move |k| (vec2((k % n) as f32, (k / n) as f32) + 0.5) / n as f32)
}
