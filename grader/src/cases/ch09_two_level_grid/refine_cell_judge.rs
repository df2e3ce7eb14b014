//! The judge of `refine_cell`: every entry by where its shape and its cell are.

use raybook::accel::lattice::Lattice;
use crate::Verdict;
use raybook::math::aabb::Aabb;
use raybook_workbook::exercises::ch05_box::Corners;
use raybook_workbook::exercises::ch09_two_level_grid::{Entry, RefineCellAnswer, RefineCell};
use glam::UVec3;

/// The resolution, then every shape in the cells that it reaches and in no other.
pub(super) fn judge(
    q: &RefineCell,
    golden: &RefineCellAnswer,
    got: &RefineCellAnswer,
) -> Verdict {
    let cells = |n: &RefineCellAnswer| UVec3::new(n.nx, n.ny, n.nz);
    let (right, along) = (cells(golden), cells(got));
    if right != along {
        return Err(format!(
            "you cut it into {} × {} × {} fine cells, and {} × {} × {} are asked for",
            along.x, along.y, along.z, right.x, right.y, right.z
        ));
    }
    if right == UVec3::ZERO {
        return Ok(());
    }
    let bounds = Aabb {
        min: q.min,
        max: q.max,
    };
    let fine = Lattice::new(&bounds, right);
    for (i, entry) in got.entries.iter().enumerate() {
        let cell = UVec3::new(entry.x, entry.y, entry.z);
        let Some(shape) = q.shapes.get(entry.shape as usize) else {
            return Err(format!("there is no shape {}", entry.shape));
        };
        if cell.cmpge(right).any() {
            return Err(format!("there is no cell {cell}"));
        }
        if got.entries[..i].contains(entry) {
            return Err(format!("shape {} is twice in cell {cell}", entry.shape));
        }
        if depth(&fine, cell, shape) < -TOLERANCE {
            return Err(format!("shape {} does not reach cell {cell}", entry.shape));
        }
    }
    let missing = golden.entries.iter().find(|entry| {
        let cell = UVec3::new(entry.x, entry.y, entry.z);
        let deep = depth(&fine, cell, &q.shapes[entry.shape as usize]) > TOLERANCE;
        deep && !got.entries.contains(entry)
    });
    match missing {
        Some(Entry { x, y, z, shape }) => Err(format!(
            "shape {shape} reaches cell [{x}, {y}, {z}], which does not name it"
        )),
        None => Ok(()),
    }
}

/// A shape may reach a cell by so little, in metres, or miss it, and either answer is right.
const TOLERANCE: f32 = 1e-4;

/// How far a box reaches into a cell; negative if it does not.
pub(super) fn depth(fine: &Lattice, cell: UVec3, shape: &Corners) -> f32 {
    let Aabb { min, max } = fine.bounds_of(cell, cell);
    (shape.max.min(max) - shape.min.max(min)).min_element()
}
