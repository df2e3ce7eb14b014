//! Chapter 21: `geodesic_step`, `deflection_angle`.

mod deflection_angle;
mod geodesic_step;

use crate::examine::Examiner;
use raybook_workbook::exercises::ch21_black_hole::{DeflectionAngle, GeodesicStep};

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&GeodesicStep, &DeflectionAngle];
