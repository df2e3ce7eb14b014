//! Chapter 15: `shadow_ray`, `lit`.

mod lit;
mod shadow_ray;
mod way;

use crate::examine::Examiner;
use raybook_workbook::exercises::ch15_shadows::{Lit, ShadowRay};

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&ShadowRay, &Lit];
