//! The latitude–longitude map, also called equirectangular map or sphere map: like a map of the world, seen from inside.
//!
//! ```
//! use raybook::light::environment::latlong;
//! use raybook::prelude::*;
//!
//! assert_eq!(latlong::place(-Dir3::Z), vec2(0.5, 0.5)); // the middle of the map
//! assert!(latlong::direction(vec2(0.75, 0.5)).dot(*Dir3::X) > 0.999); // a quarter turn to the right
//! ```

use crate::math::dir3::Dir3;
use glam::{Vec2, Vec3, vec2};
use std::f32::consts::{PI, TAU};

// ANCHOR: direction_to_latlong
/// The place of a direction on the map, from the top left: u in [0, 1), v in [0, 1].
///
/// The middle is −z, +x is to the right of it, and −x to the left; +y is the top edge and −y the bottom edge. With θ the angle
/// from +y and φ the angle from −z towards +x, the place is (½ + φ/2π, θ/π). θ is computed by atan2, because near a pole the arc
/// cosine of y loses half of its digits.
pub fn place(direction: Dir3) -> Vec2 {
    let theta = vec2(direction.x, direction.z).length().atan2(direction.y);
    let phi = direction.x.atan2(-direction.z);
    let turn = 0.5 + phi / TAU;
    // φ = π is the right edge, which is the same meridian as the left edge.
    vec2(if turn < 1.0 { turn } else { 0.0 }, theta / PI)
}
// ANCHOR_END: direction_to_latlong

// ANCHOR: latlong_direction
/// The direction at a place (u, v) on the map: the inverse of [`place`].
pub fn direction(place: Vec2) -> Dir3 {
    let (sin, cos) = (PI * place.y).sin_cos();
    around(place.x, cos, sin)
}
// ANCHOR_END: latlong_direction

/// The direction at u = `turn` and cos θ = `cosine`. The cosine is an `f64`, because it is nearly 1 in the whole first row of a
/// large map.
pub fn toward(turn: f32, cosine: f64) -> Dir3 {
    let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
    around(turn, cosine as f32, sine as f32)
}

/// cos θ at the upper edge of row `row` of texels, from 0, in a map of `rows` rows; −1, the lower edge of the last row, for
/// `row` = `rows`.
pub fn cosine(row: usize, rows: usize) -> f64 {
    (std::f64::consts::PI * row as f64 / rows as f64).cos()
}

// ANCHOR: latlong_around
/// The direction at u = `turn`, from the cosine and the sine of θ: with φ = 2π(u − ½), (sin θ sin φ, cos θ, −sin θ cos φ).
fn around(turn: f32, cosine: f32, sine: f32) -> Dir3 {
    let (sin, cos) = (TAU * (turn - 0.5)).sin_cos();
    Dir3::new_or(Vec3::new(sine * sin, cosine, -sine * cos), Dir3::Y)
}
// ANCHOR_END: latlong_around
