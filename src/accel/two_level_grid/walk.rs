//! A walk through coarse cells, and in each that is not empty through its fine cells.

use crate::accel::{two_level_grid::levels::Levels, walk::walk};
use crate::math::{interval::Interval, ray::Ray};
use std::ops::ControlFlow;

// ANCHOR: two_level_walk
/// Visits the cells that the ray passes through within the interval, in order, until `visit` breaks off: each coarse cell,
/// as `None`, and after it, unless it is empty, those of its fine cells that the ray passes through, by their places in the
/// row of all.
///
/// It is the grid's walk twice. The inner walk begins where the outer one has got to, and ends by itself where it leaves the
/// coarse cell.
pub fn walk_two_levels(
    levels: &Levels,
    ray: &Ray,
    within: Interval,
    mut visit: impl FnMut(Option<usize>, Interval) -> ControlFlow<()>,
) {
    walk(&levels.top, ray, within, |coarse, inside| {
        visit(None, inside)?;
        let Some((first, fine)) = levels.fine(coarse) else {
            return ControlFlow::Continue(());
        };
        let mut so_far = ControlFlow::Continue(());
        walk(
            &fine,
            ray,
            Interval::new(inside.min, within.max),
            |cell, inside| {
                so_far = visit(Some(first + fine.index(cell)), inside);
                so_far
            },
        );
        so_far
    });
}
// ANCHOR_END: two_level_walk
