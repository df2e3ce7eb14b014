//! The latitude–longitude map, also called equirectangular, or sphere map: a map of the world, seen from inside.

use crate::math::dir3::Dir3;
use glam::{Vec2, Vec3, vec2};
use std::f32::consts::{PI, TAU};

// ANCHOR: direction_to_latlong
/// Where a direction is on the map, in [0, 1)² from the top left.
///
/// The middle is −z, right of it +x, left of it −x; +y is the top edge and −y the bottom edge. With θ the angle from +y and
/// φ the angle from −z towards +x, the place is (½ + φ/2π, θ/π). θ comes from atan2: near a pole, the arc cosine of y
/// would have lost half of its digits.
pub fn place(direction: Dir3) -> Vec2 {
    let theta = vec2(direction.x, direction.z).length().atan2(direction.y);
    let phi = direction.x.atan2(-direction.z);
    let turn = 0.5 + phi / TAU;
    // φ = π is the right edge, which is the left edge.
    vec2(if turn < 1.0 { turn } else { 0.0 }, theta / PI)
}
// ANCHOR_END: direction_to_latlong

// ANCHOR: latlong_direction
/// The direction at a place on the map.
pub fn direction(place: Vec2) -> Dir3 {
    let (sin, cos) = (PI * place.y).sin_cos();
    around(place.x, cos, sin)
}
// ANCHOR_END: latlong_direction

/// The direction at a fraction of a turn, u, and a cosine of θ, which needs its digits: all of a large map's first row
/// has a cosine that is nearly 1.
pub fn toward(turn: f32, cosine: f64) -> Dir3 {
    let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
    around(turn, cosine as f32, sine as f32)
}

/// cos θ at the upper edge of a row of texels, the first being 0; at the lower one of the last row, if it is called the next.
pub fn cosine(row: usize, rows: usize) -> f64 {
    (std::f64::consts::PI * row as f64 / rows as f64).cos()
}

// ANCHOR: latlong_around
/// The direction at a fraction of a turn, by the cosine and the sine of θ.
fn around(turn: f32, cosine: f32, sine: f32) -> Dir3 {
    let (sin, cos) = (TAU * (turn - 0.5)).sin_cos();
    Dir3::new_or(Vec3::new(sine * sin, cosine, -sine * cos), Dir3::Y)
}
// ANCHOR_END: latlong_around
