//! Chapter 9: `refine_cell`, `two_level_walk`.

mod refine_cell;
mod refine_cell_cases;
mod refine_cell_judge;
mod two_level_walk;
mod two_level_walk_cases;

use crate::grade::examine::Examiner;
use crate::workbook::exercises::ch09_two_level_grid::{RefineCell, TwoLevelWalk};

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&RefineCell, &TwoLevelWalk];
