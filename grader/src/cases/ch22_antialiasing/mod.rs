//! Chapter 22: `regular_grid`, `rotated_grid`, `random_pattern`, `jittered`, `poisson_disk`, `pixel_average`.
//!
//! Random points are judged by what they have in common: where they are allowed to be, how far apart, how evenly they fill.
//! A bound that chance may break is broken by it with a probability below 1e-8 a case: below 1e-4 for 500 students of 41
//! cases, whatever generator they use.

mod points;

raybook_workbook::ch22_antialiasing!(graded);
