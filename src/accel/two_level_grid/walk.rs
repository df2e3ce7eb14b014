//! A walk through coarse cells, and in each that is not empty through its fine cells.

use crate::accel::{lattice::index, two_level_grid::levels::Levels, walk::walk};
use crate::math::{interval::Interval, ray::Ray};
use glam::UVec3;
use std::ops::ControlFlow;

// ANCHOR: two_level_walk
/// Visits the cells that the ray passes through within the interval, in order, until `visit` breaks off: each coarse cell,
/// as `None`, and after it, unless it is empty, those of its fine cells that the ray passes through, by their places in the
/// row of all.
///
/// It is the grid's walk twice. The inner walk begins and ends where the outer one enters and leaves the coarse cell, and goes
/// through the whole grid, cut everywhere as finely as this coarse cell. For a ray that runs in a plane between two coarse
/// cells, up to rounding, either may be its cell: the outer walk alone decides. Were the inner one to ask again whether the
/// ray is in that cell, it would sometimes say no, and hits would be lost. So a fine cell beyond the plane stands for the
/// nearest one of this coarse cell.
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
