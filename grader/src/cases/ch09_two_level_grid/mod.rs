//! Chapter 9: `refine_cell`, `two_level_walk`.

mod refine_cell;
mod refine_cell_cases;
mod refine_cell_judge;
mod two_level_walk;
mod two_level_walk_cases;

use crate::examine::Examiner;
use raybook_workbook::exercises::ch09_two_level_grid::{RefineCell, TwoLevelWalk};

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&RefineCell, &TwoLevelWalk];
