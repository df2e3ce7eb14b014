//! Points of a regular polygon, all of them equally likely.

use glam::Vec2;
use std::f32::consts::TAU;

// ANCHOR: regular_polygon
/// The point of the regular polygon with n corners on the unit circle, the first of them at the angle `turn`, that belongs to
/// u in [0, 1]².
///
/// u.y goes around: n·u.y is the number of a corner and the share v of the way to the next, whose corners are p and q.
/// u.x goes outwards: of a triangle with a corner in the middle, the part up to the share √u.x has the share u.x of its area
/// (Turk, "Generating random points in triangles", 1990). Fewer than three corners count as three.
pub fn regular_polygon(n: u32, turn: f32, u: Vec2) -> Vec2 {
    let n = n.max(3) as f32;
    let around = (n * u.y).min(n);
    let k = around.floor().min(n - 1.0);
    let corner = |k: f32| Vec2::from_angle(turn + TAU * k / n);
    u.x.sqrt() * corner(k).lerp(corner(k + 1.0), around - k)
}
// ANCHOR_END: regular_polygon
