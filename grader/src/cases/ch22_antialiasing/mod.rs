//! Chapter 22: `regular_grid`, `rotated_grid`, `random_pattern`, `jittered`, `poisson_disk`, `pixel_average`.
//!
//! Random points are judged by what they have in common: where they are allowed to be, how far apart, how evenly they fill.
//! How seldom chance breaks their bounds at a right answer is counted in `together.rs`.

mod points;

raybook_workbook::ch22_antialiasing!(graded);
