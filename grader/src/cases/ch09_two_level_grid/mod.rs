//! Chapter 9: `refine_cell`, `two_level_walk`.

mod refine_cell_cases;
mod refine_cell_judge;
mod two_level_walk_cases;


raybook_workbook::ch09_two_level_grid!(graded);
