//! Chapter 8: `grid_resolution`, `voxels_of_triangle`, `grid_walk`.

raybook_workbook::ch08_grid!(graded);
