//! Chapter 6: `triangle_hit`, `triangle_normal`.

mod triangle_hit;
mod triangle_hit_cases;
mod triangle_normal;

use crate::grade::examine::Examiner;
use crate::workbook::exercises::ch06_triangle::{TriangleHit, TriangleNormal};

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&TriangleHit, &TriangleNormal];
