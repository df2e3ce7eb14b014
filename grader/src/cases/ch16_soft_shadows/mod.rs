//! Chapter 16: `sample_rect`, `sample_sphere_light`, `visible_fraction`.

mod chosen;
mod cone;
mod flaws;

use glam::{Vec2, Vec3, vec2};
use raybook::math::dir3::Dir3;

raybook_workbook::ch16_soft_shadows!(graded);

/// The middles of the cells of an n × n lattice.
fn lattice(n: u32) -> impl Iterator<Item = Vec2> {
    (0..n * n).map(move |k| (vec2((k % n) as f32, (k / n) as f32) + 0.5) / n as f32)
}

/// An axis of the world, or another where a direction is nearly along it.
pub(super) fn unless_near(direction: Dir3, axis: Vec3, other: Vec3) -> Vec3 {
    if direction.dot(axis).abs() < 0.9 {
        axis
    } else {
        other
    }
}

/// Axes beside a direction that are cross products with another vector, and not of length 1.
pub(super) fn crossed(direction: Dir3, up: Vec3) -> [Vec3; 2] {
    let x = up.cross(*direction);
    [x, direction.cross(x)]
}
