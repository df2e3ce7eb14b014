//! Polygons in double precision.

use glam::DVec3;

/// The part of a polygon on which a distance is not negative (Sutherland and Hodgman 1974).
pub fn clipped(polygon: &[DVec3], distance: impl Fn(DVec3) -> f64) -> Vec<DVec3> {
    let mut kept = Vec::new();
    for (i, &p) in polygon.iter().enumerate() {
        let q = polygon[(i + 1) % polygon.len()];
        let (a, b) = (distance(p), distance(q));
        if a >= 0.0 {
            kept.push(p);
        }
        if a * b < 0.0 {
            kept.push(p.lerp(q, a / (a - b)));
        }
    }
    kept
}
