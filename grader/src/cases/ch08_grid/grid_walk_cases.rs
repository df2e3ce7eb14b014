//! The questions of `grid_walk`.

use crate::{sample};
use raybook::math::aabb::Aabb;
use raybook::math::{dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray, slab};
use raybook_workbook::exercises::ch08_grid::GridWalk;
use glam::{uvec3, vec3};
use rand::RngExt;

/// An ordinary question.
pub(super) fn random(rng: &mut Pcg) -> GridWalk {
    let mut count = || rng.random_range(1..7_u32);
    let n = uvec3(count(), count(), count());
    let cell = vec3(1.0, 0.7, 1.2) * sample::number(rng, 0.4, 1.5);
    let min = sample::point(rng, 3.0);
    let (center, half) = (min + 0.5 * n.as_vec3() * cell, 0.5 * n.as_vec3() * cell);
    let origin = center + sample::point(rng, 1.8) * half;
    let aim = center + sample::point(rng, 0.9) * half;
    let ray = Ray::new(origin, Dir3::new_or(aim - origin, Dir3::X));
    let bounds = Aabb {
        min,
        max: min + 2.0 * half,
    };
    // From the middle of what is inside, or up to there.
    let inside = slab::clip(&bounds, &ray, Interval::AHEAD).unwrap_or(Interval::AHEAD);
    let middle = 0.5 * (inside.min + inside.max);
    let within = match rng.random_range(0..6) {
        0 => Interval::new(0.0, middle),
        1 | 2 => Interval::new(middle, f32::INFINITY),
        _ => Interval::AHEAD,
    };
    GridWalk {
        min,
        cell,
        nx: n.x,
        ny: n.y,
        nz: n.z,
        ray,
        within,
    }
}

