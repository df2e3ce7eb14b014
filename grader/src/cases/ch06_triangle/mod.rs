//! Chapter 6: `triangle_hit`, `triangle_normal`.

mod triangle_hit;
mod triangle_hit_cases;
mod triangle_normal;

use crate::examine::Examiner;
use raybook_workbook::exercises::ch06_triangle::{TriangleHit, TriangleNormal};

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&TriangleHit, &TriangleNormal];
