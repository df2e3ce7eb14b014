//! The cells of points of a triangle, by which students take the whole triangle into cells.

use super::overlaps::of_lattice;
use glam::Vec3;
use raybook_workbook::exercises::ch08_grid::{Cell, VoxelsOfTriangle};

/// What leads from points to the triangle between them.
pub(super) const BETWEEN: &str = "Between two of your points the triangle goes on: can it cut off the corner of a cell there, and does any number of points rule that out?";

/// The cells, each larger by the margin on every side, that hold one of the points in steps along two edges: p0 + i/steps·(p1 − p0) +
/// j/steps·(p2 − p0), with i + j ≤ steps.
pub(super) fn of_points(q: &VoxelsOfTriangle, steps: u32, margin: f32) -> Vec<Cell> {
    let step = 1.0 / steps as f32;
    let (along, across) = (step * (q.p1 - q.p0), step * (q.p2 - q.p0));
    let row = |i: u32| (0..=steps - i).map(move |j| i as f32 * along + j as f32 * across);
    let points: Vec<_> = (0..=steps).flat_map(row).map(|way| q.p0 + way).collect();
    holding(q, &points, margin)
}

/// The cell that holds the triangle's middle.
pub(super) fn of_middle(q: &VoxelsOfTriangle, margin: f32) -> Vec<Cell> {
    holding(q, &[(q.p0 + q.p1 + q.p2) / 3.0], margin)
}

/// The cells, each larger by the margin on every side, that hold one of these points.
fn holding(q: &VoxelsOfTriangle, points: &[Vec3], margin: f32) -> Vec<Cell> {
    of_lattice(q, |bounds, _| {
        let bounds = bounds.grown(margin);
        points.iter().any(|&p| bounds.contains(p))
    })
}
