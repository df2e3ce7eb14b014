//! Chapter 25: `trace`.

mod glass_cases;
mod light_cases;
mod random;
mod slip;
mod things;
mod trace;
mod trace_judge;
mod trace_mistakes;
mod tracer;

use crate::grade::examine::Examiner;
use crate::workbook::exercises::ch25_capstone::Trace;

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&Trace];
