//! Chapter 23: `needs_more`, `spend_budget`.

mod measures;
mod needs_more;
mod spend_budget;

use crate::examine::Examiner;
use raybook_workbook::exercises::ch23_adaptive::{NeedsMore, SpendBudget};

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&NeedsMore, &SpendBudget];
