//! Chapter 25: `trace`.

use crate::grade::examine::Examiner;

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[];
