//! The cells that a ray passes through, one after the other.

use crate::accel::{lattice::Lattice, ray_box::RayBox};
use crate::math::{interval::Interval, ray::Ray};
use glam::{UVec3, Vec3, vec3};
use std::ops::ControlFlow;

// ANCHOR: grid_walk
/// Visits the cells of the lattice that the ray passes through within the interval, in order, each with the distances at which
/// the ray enters and leaves the cell, until `visit` returns `Break` (3D-DDA: Amanatides and Woo, "A fast voxel traversal
/// algorithm for ray tracing", 1987).
///
/// Per axis, the ray meets the next plane, number i, at tᵢ = (min − o)/d + i·(cell/d). The least of the three distances tells
/// through which face the ray leaves the cell: one step along that axis follows, and the next plane there is cell/d further on.
/// tᵢ is computed from i, not by adding cell/d again and again, because then the rounding errors would add up too.
///
/// Every visit but the last is followed by one step, and no step goes back. So the number of visits is at most the sum of the
/// three resolutions, whatever the numbers are. A ray through an edge or a corner makes its steps one after the other, in any
/// order. By rounding, a cell may be visited that the ray only touches; then enter ≥ leave.
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
    let first = (lattice.min - ray.origin) / *ray.direction;
    let apart = lattice.cell / *ray.direction;
    // The sign bit, not d < 0: with −0.0 the ray stays in its cell just as with +0.0.
    let backward = |axis: usize| ray.direction[axis].is_sign_negative();
    let plane_ahead = |axis: usize, cell: u32| {
        let plane = cell + u32::from(!backward(axis));
        let t = first[axis] + plane as f32 * apart[axis];
        // ∞, −∞ or ∞ − ∞ where the ray does not move along this axis, or hardly: then it never meets a plane.
        if t.is_finite() { t } else { f32::INFINITY }
    };
    let mut next = vec3(
        plane_ahead(0, cell.x),
        plane_ahead(1, cell.y),
        plane_ahead(2, cell.z),
    );
    let step = |axis: usize, cell: &mut UVec3, next: &mut Vec3| {
        let last = if backward(axis) {
            0
        } else {
            lattice.resolution[axis] - 1
        };
        if cell[axis] == last {
            return false;
        }
        cell[axis] = if backward(axis) {
            cell[axis] - 1
        } else {
            cell[axis] + 1
        };
        next[axis] = plane_ahead(axis, cell[axis]);
        true
    };
    loop {
        let leave = lesser(lesser(next.x, next.y), lesser(next.z, within.max));
        let seen = visit(cell, Interval::new(enter, leave));
        if seen.is_break() || leave >= within.max {
            return;
        }
        // The axes are constants, so that the compiler keeps the vectors in registers.
        let inside = if next.x < next.y && next.x < next.z {
            step(0, &mut cell, &mut next)
        } else if next.y < next.z {
            step(1, &mut cell, &mut next)
        } else {
            step(2, &mut cell, &mut next)
        };
        if !inside {
            return;
        }
        enter = leave;
    }
}
// ANCHOR_END: grid_walk

/// The lesser of two numbers that are not NaN: one instruction, whereas `f32::min` needs more to handle NaN.
fn lesser(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

/// `Break`, which ends a walk, if `done`; else `Continue`.
pub(crate) fn break_if(done: bool) -> ControlFlow<()> {
    if done {
        ControlFlow::Break(())
    } else {
        ControlFlow::Continue(())
    }
}
