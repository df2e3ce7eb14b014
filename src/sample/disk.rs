//! Points of a disc, uniform over its area.
//!
//! ```
//! use glam::vec2;
//! use raybook::sample::disk::concentric_disk;
//!
//! assert_eq!(concentric_disk(vec2(0.5, 0.5)).length(), 0.0); // the middle stays the middle
//! assert!((concentric_disk(vec2(1.0, 0.2)).length() - 1.0).abs() < 1e-6); // an edge becomes the rim
//! ```

use glam::Vec2;
use std::f32::consts::{FRAC_PI_2, FRAC_PI_4};

// ANCHOR: concentric_disk
/// The point of the unit disc for u in [0, 1]²: squares around the middle become circles around the middle
/// (Shirley and Chiu, "A low distortion map between disk and square", 1997).
///
/// With (a, b) = 2u − 1, the square through (a, b) has the half side r = max(|a|, |b|), and becomes the circle of radius r: both
/// areas grow as r². Equal steps along a side become equal angles: φ = π/4 · b/a on the sides with |a| ≥ |b|, and
/// φ = π/2 − π/4 · a/b on the others. A negative r turns φ by π. So equal areas become equal areas, neighbours stay
/// neighbours, and a pattern that fills the square evenly fills the disc evenly.
pub fn concentric_disk(u: Vec2) -> Vec2 {
    let (a, b) = (2.0 * u - 1.0).into();
    if a == 0.0 && b == 0.0 {
        return Vec2::ZERO; // the middle has no angle
    }
    let (r, phi) = if a.abs() > b.abs() {
        (a, FRAC_PI_4 * b / a)
    } else {
        (b, FRAC_PI_2 - FRAC_PI_4 * a / b)
    };
    r * Vec2::from_angle(phi)
}
// ANCHOR_END: concentric_disk
