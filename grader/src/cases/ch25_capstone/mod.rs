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

use crate::examine::Examiner;
use raybook_workbook::exercises::ch25_capstone::Trace;

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&Trace];
