//! Chapter 5: `box_clip`, `bounds_of`.

mod bounds_of;
mod box_clip;
mod box_clip_cases;

use crate::examine::Examiner;
use raybook_workbook::exercises::ch05_box::{BoundsOf, BoxClip};

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&BoxClip, &BoundsOf];
