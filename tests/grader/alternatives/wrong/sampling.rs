//! Chapters 22 and 23: patterns, filters, budgets.

use crate::alternatives::wrong::{Wrong, scale};

const GRIDS: &[&str] = &["regular_grid", "rotated_grid"];
const SPREAD: &[&str] = &["jittered", "poisson_disk"];

pub const WRONGS: &[Wrong] = &[
    (GRIDS, "the first is 0.01 to the right", |points| {
        if points.len() > 1 {
            points[1] += 0.01;
        }
    }),
    (&["random_pattern"], "half of them twice", |points| {
        let half = (points.len() - 1) / 4 * 2;
        points.copy_within(1..=half, half + 1);
    }),
    (SPREAD, "the second is where the first is", |points| {
        if points.len() > 4 {
            points.copy_within(1..3, 3);
        }
    }),
    (&["pixel_average"], "1 % too bright", |l| scale(l, 1.01)),
    (&["needs_more"], "the other way round", |more| {
        more[0] = 1.0 - more[0];
    }),
    (&["spend_budget"], "one too many for the last", |counts| {
        *counts.last_mut().expect("a count") += 1.0;
    }),
];
