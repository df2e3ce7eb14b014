//! The cells that a ray passes through, one after the other.

use crate::accel::{lattice::Lattice, ray_box::RayBox};
use crate::math::{interval::Interval, ray::Ray};
use glam::UVec3;
use std::ops::ControlFlow;

// ANCHOR: grid_walk
/// Visits the cells of the lattice that the ray passes through within the interval, in order, each with the distances
/// at which the ray enters and leaves it, until `visit` breaks off (a 3D-DDA: Amanatides and Woo 1987).
///
/// Per axis, the ray meets the next plane, number i, at tᵢ = (min − o)/d + i·(cell/d). The least of the three distances
/// says through which face the ray leaves the cell; one step along that axis, and the next plane there comes one cell/d later.
/// tᵢ is computed from i and not by adding cell/d over and over, for the errors would add up too.
///
/// Every visit but the last makes one step, and a step never goes back, so there are at most as many visits as the
/// resolutions add up to, whatever the numbers are. A ray through an edge or a corner makes its steps one after the other,
/// in either order. By rounding, a cell may be visited that the ray only touches; then enter ≥ leave.
pub fn walk(
    lattice: &Lattice,
    ray: &Ray,
    within: Interval,
    mut visit: impl FnMut(UVec3, Interval) -> ControlFlow<()>,
) {
    let Some(mut enter) = RayBox::new(ray).enters(&lattice.bounds(), within) else {
        return;
    };
    let mut cell = lattice.cell_at(ray.at(enter));
    let inverse = ray.direction.recip();
    let first = ((lattice.min - ray.origin) * inverse).to_array();
    let apart = (lattice.cell * inverse).to_array();
    // The sign bit, not d < 0: with −0.0 the ray stays in its cell just as with +0.0.
    let backward = ray.direction.to_array().map(f32::is_sign_negative);
    let plane = |axis: usize, cell: UVec3| {
        let ahead = cell[axis] + u32::from(!backward[axis]);
        let t = first[axis] + ahead as f32 * apart[axis];
        // ∞ − ∞ where the ray does not move along this axis: it never meets a plane.
        if t.is_nan() { f32::INFINITY } else { t }
    };
    let mut next = [0, 1, 2].map(|axis| plane(axis, cell));
    let last = [0, 1, 2].map(|axis| {
        if backward[axis] {
            0
        } else {
            lattice.resolution[axis] - 1
        }
    });
    let step = |cell: &mut UVec3, next: &mut [f32; 3], axis: usize| {
        let ends = cell[axis] == last[axis];
        cell[axis] = if backward[axis] {
            cell[axis].wrapping_sub(1)
        } else {
            cell[axis] + 1
        };
        next[axis] = plane(axis, *cell);
        ends
    };
    loop {
        let leave = next[0].min(next[1]).min(next[2]).min(within.max);
        let visited = visit(cell, Interval::new(enter, leave));
        if visited.is_break() || leave >= within.max {
            return;
        }
        let ends = match least(next) {
            0 => step(&mut cell, &mut next, 0),
            1 => step(&mut cell, &mut next, 1),
            _ => step(&mut cell, &mut next, 2),
        };
        if ends {
            return;
        }
        enter = leave;
    }
}
// ANCHOR_END: grid_walk

/// Which of three numbers is the least.
fn least([x, y, z]: [f32; 3]) -> usize {
    match (x < y, x < z, y < z) {
        (true, true, _) => 0,
        (false, _, true) => 1,
        _ => 2,
    }
}
