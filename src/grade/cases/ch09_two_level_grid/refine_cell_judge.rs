//! `refine_cell_judge`: its cases, judge and mistakes.

use crate::accel::lattice::Lattice;
use crate::math::aabb::Aabb;
use crate::workbook::exercises::ch05_box::Corners;
use crate::workbook::exercises::ch09_two_level_grid::{
    Entry, RefineCellAnswer, RefineCellQuestion,
};
use glam::UVec3;

/// A shape may reach a cell by so little, in metres, or miss it, and either answer is right.
pub(super) const TOLERANCE: f32 = 1e-4;

/// How far a box reaches into a cell; negative if it does not.
pub(super) fn depth(fine: &Lattice, cell: UVec3, shape: &Corners) -> f32 {
    let Aabb { min, max } = fine.bounds_of(cell, cell);
    (shape.max.min(max) - shape.min.max(min)).min_element()
}

/// The answer for a resolution of one's own.
pub(super) fn cut(q: &RefineCellQuestion, along: UVec3) -> RefineCellAnswer {
    let bounds = Aabb {
        min: q.min,
        max: q.max,
    };
    let fine = Lattice::new(&bounds, along);
    let mut entries = Vec::new();
    for cell in fine.all() {
        for (shape, corners) in (0..).zip(&q.shapes) {
            if depth(&fine, cell, corners) >= 0.0 {
                entries.push(Entry {
                    x: cell.x,
                    y: cell.y,
                    z: cell.z,
                    shape,
                });
            }
        }
    }
    RefineCellAnswer {
        nx: along.x,
        ny: along.y,
        nz: along.z,
        entries,
    }
}
