//! Chapter 8: `grid_resolution`, `voxels_of_triangle`, `grid_walk`.

mod grid_walk_cases;
mod grid_walk_student;
mod voxels_of_triangle_cases;


raybook_workbook::ch08_grid!(graded);
