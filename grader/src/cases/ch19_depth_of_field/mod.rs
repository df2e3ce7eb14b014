//! Chapter 19: `concentric_disk`, `thin_lens_ray`, `circle_of_confusion`.

mod circle_of_confusion;
mod concentric_disk;
mod thin_lens_ray;
mod thin_lens_ray_cases;

use crate::examine::Examiner;
use raybook_workbook::exercises::ch19_depth_of_field::{
    CircleOfConfusion, ConcentricDisk, ThinLensRay,
};

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&ConcentricDisk, &ThinLensRay, &CircleOfConfusion];
