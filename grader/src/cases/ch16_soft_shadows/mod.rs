//! Chapter 16: `sample_rect`, `sample_sphere_light`, `visible_fraction`.

mod chosen;
mod cone;
mod flaws;

use glam::{Vec2, vec2};

raybook_workbook::ch16_soft_shadows!(graded);

/// The middles of the cells of an n × n lattice.
fn lattice(n: u32) -> impl Iterator<Item = Vec2> {
    (0..n * n).map(move |k| (vec2((k % n) as f32, (k / n) as f32) + 0.5) / n as f32)
}
