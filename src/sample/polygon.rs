//! Points of a regular polygon, uniform over its area.
//!
//! ```
//! use glam::vec2;
//! use raybook::sample::polygon::regular_polygon;
//!
//! let corner = regular_polygon(6, 0.0, vec2(1.0, 0.0));
//! assert!(corner.distance(vec2(1.0, 0.0)) < 1e-6); // on the unit circle
//! let middle_of_side = regular_polygon(6, 0.0, vec2(1.0, 1.0 / 12.0));
//! assert!((middle_of_side.length() - 0.75_f32.sqrt()).abs() < 1e-6); // nearer to the middle
//! ```

use glam::Vec2;
use std::f32::consts::TAU;

// ANCHOR: regular_polygon
/// The point, for u in [0, 1]², of the regular polygon with n corners on the unit circle. The first corner is at the angle
/// `turn`, in radians. Fewer than three corners count as three.
///
/// u.y goes around the polygon: the whole part of n·u.y is the number of a corner, and the rest is the share of the way to the
/// next corner. u.x goes outwards: the part of a triangle up to the share √u.x of the way from the middle has the share u.x of
/// the triangle's area (Turk, "Generating random points in triangles", 1990).
pub fn regular_polygon(n: u32, turn: f32, u: Vec2) -> Vec2 {
    let n = n.max(3) as f32;
    let around = (n * u.y).min(n);
    let k = around.floor().min(n - 1.0);
    let corner = |k: f32| Vec2::from_angle(turn + TAU * k / n);
    u.x.sqrt() * corner(k).lerp(corner(k + 1.0), around - k)
}
// ANCHOR_END: regular_polygon
