//! Chapter 21: `geodesic_step`, `deflection_angle`.

mod deflection_angle;
mod geodesic_step;

use crate::grade::examine::Examiner;
use crate::workbook::exercises::ch21_black_hole::{DeflectionAngle, GeodesicStep};

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&GeodesicStep, &DeflectionAngle];
