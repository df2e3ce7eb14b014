//! Chapter 8: `grid_resolution`, `voxels_of_triangle`, `grid_walk`.

mod grid_resolution;
mod grid_walk;
mod grid_walk_cases;
mod grid_walk_student;
mod voxels_of_triangle;
mod voxels_of_triangle_cases;

use crate::examine::Examiner;
use raybook_workbook::exercises::ch08_grid::{GridResolution, GridWalk, VoxelsOfTriangle};

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&GridResolution, &VoxelsOfTriangle, &GridWalk];
