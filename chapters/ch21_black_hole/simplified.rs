//! Curves with few corners. The place of each corner is rounded to pixels, so that close corners make a curve wavy.

use glam::DVec2;

/// Distance that a curve may have from the points, in pixels.
const NEAR: f64 = 0.5;

/// The corners of a line that is near all points, from the first point to the last one (Ramer 1972; Douglas and Peucker 1973).
pub(super) fn simplified(points: &[DVec2]) -> Vec<DVec2> {
    let mut corners: Vec<_> = points.first().copied().into_iter().collect();
    add_corners(points, &mut corners);
    corners
}

/// Adds the corners after the first point.
fn add_corners(points: &[DVec2], corners: &mut Vec<DVec2>) {
    let [first, between @ .., last] = points else {
        return;
    };
    let along = (*last - *first).normalize_or_zero();
    let off = |p: &DVec2| (*p - *first).perp_dot(along).abs();
    let distances = between.iter().map(off).zip(1..);
    match distances.max_by(|a, b| a.0.total_cmp(&b.0)) {
        Some((distance, i)) if distance > NEAR => {
            add_corners(&points[..=i], corners);
            add_corners(&points[i..], corners);
        }
        _ => corners.push(*last),
    }
}
