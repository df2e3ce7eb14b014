//! Chapter 22: `regular_grid`, `rotated_grid`, `random_pattern`, `jittered`, `poisson_disk`, `pixel_average`.
//!
//! Random points are judged by what they have in common: where they are allowed to be, how far apart, how evenly they fill.
//! A bound that chance may break is broken by it with a probability below 1e-8 a case: below 1e-4 for 500 students of 41
//! cases, whatever generator they use.

mod jittered;
mod pixel_average;
mod points;
mod poisson_disk;
mod random_pattern;
mod regular_grid;
mod rotated_grid;

use crate::examine::Examiner;
use raybook_workbook::exercises::ch22_antialiasing::{
    Jittered, PixelAverage, PoissonDisk, RandomPattern, RegularGrid, RotatedGrid,
};

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[
    &RegularGrid,
    &RotatedGrid,
    &RandomPattern,
    &Jittered,
    &PoissonDisk,
    &PixelAverage,
];
