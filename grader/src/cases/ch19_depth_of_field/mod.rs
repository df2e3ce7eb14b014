//! Chapter 19: `concentric_disk`, `thin_lens_ray`, `circle_of_confusion`.

raybook_workbook::ch19_depth_of_field!(graded);
