//! Chapter 1: `ray_at`, `camera_ray`.

raybook_workbook::ch01_rays!(graded);
