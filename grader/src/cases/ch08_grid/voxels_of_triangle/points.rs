//! The cells of points of a triangle, by which students take the whole triangle into cells.

use raybook::math::aabb::Aabb;
use raybook_workbook::exercises::ch08_grid::VoxelsOfTriangle;

/// What leads from points to the triangle between them.
pub(super) const BETWEEN: &str = "Between two of your points the triangle goes on: can it cut off the corner of a cell there, and does any number of points rule that out?";

/// Whether bounds hold one of the points in steps along two edges: p0 + i/steps·(p1 − p0) + j/steps·(p2 − p0), with i + j ≤ steps.
pub(super) fn hold_a_point(q: &VoxelsOfTriangle, bounds: &Aabb, steps: u32) -> bool {
    let step = 1.0 / steps as f32;
    let (along, across) = (step * (q.p1 - q.p0), step * (q.p2 - q.p0));
    let row = |i: u32| (0..=steps - i).map(move |j| i as f32 * along + j as f32 * across);
    let mut ways = (0..=steps).flat_map(row);
    ways.any(|way| bounds.contains(q.p0 + way))
}

/// Whether bounds hold the triangle's middle.
pub(super) fn hold_the_middle(q: &VoxelsOfTriangle, bounds: &Aabb) -> bool {
    bounds.contains((q.p0 + q.p1 + q.p2) / 3.0)
}

/// Whether bounds hold a corner of the triangle.
pub(super) fn hold_a_corner(q: &VoxelsOfTriangle, bounds: &Aabb) -> bool {
    [q.p0, q.p1, q.p2].iter().any(|&p| bounds.contains(p))
}
