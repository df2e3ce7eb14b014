//! Chapter 1: `ray_at`, `camera_ray`.

mod camera_ray;
mod ray_at;

use crate::examine::Examiner;
use raybook_workbook::exercises::ch01_rays::{CameraRay, RayAt};

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[&RayAt, &CameraRay];
