//! A walk through coarse cells, and through the fine cells of those that are not empty.

use crate::accel::{lattice::index, two_level_grid::levels::Levels, walk::walk};
use crate::math::{interval::Interval, ray::Ray};
use glam::UVec3;
use std::ops::ControlFlow;

// ANCHOR: two_level_walk
/// Visits the cells that the ray passes through within the interval, in order, until `visit` returns `Break`: each coarse cell
/// as `None`, and after it the fine cells of this coarse cell that the ray passes through, by their places in the row of all
/// fine cells.
///
/// The walk of the uniform grid is used twice. The inner walk begins and ends where the outer walk enters and leaves the coarse
/// cell. It goes through the whole grid, as if all coarse cells were cut like this one. A ray that runs in a plane between two
/// coarse cells may be in either of them, by rounding: only the outer walk decides. If the inner walk decided again whether the
/// ray is in the coarse cell, the answer would sometimes be no, and hits would be lost. So a fine cell beyond the plane is
/// replaced by the nearest fine cell of this coarse cell.
pub fn walk_two_levels(
    levels: &Levels,
    ray: &Ray,
    within: Interval,
    mut visit: impl FnMut(Option<usize>, Interval) -> ControlFlow<()>,
) {
    walk(&levels.top, ray, within, |coarse, inside| {
        visit(None, inside)?;
        let Some((first, resolution)) = levels.resolution(coarse) else {
            return ControlFlow::Continue(());
        };
        let (begin, last) = (coarse * resolution, resolution - UVec3::ONE);
        let (mut so_far, mut before) = (ControlFlow::Continue(()), None);
        walk(&levels.cut(resolution), ray, inside, |cell, inside| {
            let cell = cell.max(begin).min(begin + last) - begin;
            let place = first + index(cell, resolution);
            if before.replace(place) != Some(place) {
                so_far = visit(Some(place), inside);
            }
            so_far
        });
        so_far
    });
}
// ANCHOR_END: two_level_walk
