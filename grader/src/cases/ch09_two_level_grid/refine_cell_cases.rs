//! The questions of `refine_cell`.

use crate::{sample};
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch05_box::Corners;
use raybook_workbook::exercises::ch09_two_level_grid::RefineCell;
use glam::vec3;
use rand::RngExt;

/// An ordinary question.
pub(super) fn random(rng: &mut Pcg) -> RefineCell {
    let min = sample::point(rng, 3.0);
    let size = vec3(
        sample::number(rng, 1.0, 4.0),
        sample::number(rng, 1.0, 4.0),
        sample::number(rng, 1.0, 4.0),
    );
    let shapes = (0..rng.random_range(2..6))
        .map(|_| {
            let middle = min + size * (sample::point(rng, 0.55) + 0.5);
            let half = 0.2 * size * (sample::point(rng, 0.5) + 0.5);
            // All of them reach the cell.
            let middle = middle.clamp(min - 0.5 * half, min + size + 0.5 * half);
            Corners {
                min: middle - half,
                max: middle + half,
            }
        })
        .collect();
    RefineCell {
        min,
        max: min + size,
        density: sample::number(rng, 2.0, 6.0),
        shapes,
    }
}
