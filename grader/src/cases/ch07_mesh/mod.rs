//! Chapter 7: `interpolate_normal`, `interpolate_texture`, `vertex_normals`, `mesh_hit`.

use crate::sample;
use glam::{Vec2, vec2};
use raybook::math::pcg::Pcg;

raybook_workbook::ch07_mesh!(graded);

fn place(rng: &mut Pcg) -> Vec2 {
    let b1 = sample::number(rng, 0.0, 1.0);
    vec2(b1, (1.0 - b1) * sample::number(rng, 0.0, 1.0))
}

/// The number of the corner with the largest weight.
fn nearest_corner(b: Vec2) -> usize {
    if 1.0 - b.x - b.y >= b.x.max(b.y) {
        0
    } else if b.x >= b.y {
        1
    } else {
        2
    }
}
