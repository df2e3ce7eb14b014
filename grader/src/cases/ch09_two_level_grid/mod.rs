//! Chapter 9: `refine_cell`, `two_level_walk`.

raybook_workbook::ch09_two_level_grid!(graded);
