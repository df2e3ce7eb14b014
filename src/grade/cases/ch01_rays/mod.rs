//! Chapter 1: `ray_at`, `camera_ray`.

mod camera_ray;
mod ray_at;

use crate::grade::examine::Examiner;
use crate::workbook::exercises::ch01_rays::{CameraRay, RayAt};

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&RayAt, &CameraRay];
