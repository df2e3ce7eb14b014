//! Chapter 3: `solve_quadratic`, `sphere_hit`, `sphere_normal`.

mod solve_quadratic;
mod sphere_hit;
mod sphere_normal;

use crate::examine::Examiner;
use raybook_workbook::exercises::ch03_sphere::{SolveQuadratic, SphereHit, SphereNormal};

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&SolveQuadratic, &SphereHit, &SphereNormal];
