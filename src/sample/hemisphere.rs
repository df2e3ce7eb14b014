//! Random directions of a hemisphere: uniform, or with a density proportional to the cosine or to a power of the cosine. And of the
//! whole sphere: uniform.
//!
//! Each function makes a direction from u, uniform in [0, 1)². Its density is per steradian, and integrates to 1.
//!
//! ```
//! use glam::vec2;
//! use raybook::math::dir3::Dir3;
//! use raybook::sample::hemisphere::{cosine_hemisphere, uniform_hemisphere};
//!
//! // The mean of the cosine is 1/2 over the hemisphere, but 2/3 with a density proportional to the cosine.
//! let mean = |direction: fn(Dir3, glam::Vec2) -> Dir3| {
//!     (0..1000).map(|i| direction(Dir3::Y, vec2((i as f32 + 0.5) / 1000.0, 0.0)).y).sum::<f32>() / 1000.0
//! };
//! assert!((mean(uniform_hemisphere) - 0.5).abs() < 1e-3);
//! assert!((mean(cosine_hemisphere) - 2.0 / 3.0).abs() < 1e-3);
//! ```

use crate::math::{basis::Basis, dir3::Dir3};
use glam::{Vec2, vec3};
use std::f32::consts::{FRAC_1_PI, TAU};

/// The density of [`uniform_hemisphere`]: 1/2π, in 1/sr, because a hemisphere has 2π steradians.
pub const UNIFORM: f32 = 1.0 / TAU;

// ANCHOR: uniform_hemisphere
/// A direction, uniform over the hemisphere around a normal.
///
/// The areas of a sphere's zones are proportional to their heights (Archimedes), so cos θ is uniform: cos θ = 1 − u.x.
pub fn uniform_hemisphere(normal: Dir3, u: Vec2) -> Dir3 {
    at_height(normal, 1.0 - u.x, u.y)
}
// ANCHOR_END: uniform_hemisphere

/// A direction, uniform over the whole sphere: as [`uniform_hemisphere`], but cos θ goes from 1 to −1. Its density is 1/4π.
pub fn uniform_sphere(u: Vec2) -> Dir3 {
    at_height(Dir3::Z, 1.0 - 2.0 * u.x, u.y)
}

// ANCHOR: cosine_hemisphere
/// A direction of the hemisphere around a normal, with the density cos θ/π per steradian (Malley 1988).
///
/// A point is chosen uniformly on the unit disc: r = √u.x, φ = 2π u.y. Straight above the point, at the height √(1 − r²), is a
/// direction of the hemisphere. An area of the hemisphere is larger by 1/cos θ than its projection to the disc. So the density of
/// the directions is the density on the disc, 1/π, times cos θ.
pub fn cosine_hemisphere(normal: Dir3, u: Vec2) -> Dir3 {
    let (r, (sin, cos)) = (u.x.sqrt(), (TAU * u.y).sin_cos());
    let above_disc = vec3(r * cos, r * sin, (1.0 - u.x).sqrt());
    Dir3::new_or(Basis::around(normal).to_world(above_disc), normal)
}
// ANCHOR_END: cosine_hemisphere

/// The density of [`cosine_hemisphere`], in 1/sr, at an angle of this cosine to the normal.
pub fn cosine_pdf(cosine: f32) -> f32 {
    cosine.max(0.0) * FRAC_1_PI
}

// ANCHOR: lobe
/// A direction of the hemisphere around an axis, with the density (n + 1)/2π cosⁿα per steradian: uniform for n = 0, proportional
/// to the cosine for n = 1.
///
/// The probability of an angle below α to the axis is 1 − cosⁿ⁺¹α. It is set equal to u.x, and solved for cos α.
pub fn lobe(axis: Dir3, n: f32, u: Vec2) -> Dir3 {
    at_height(axis, (1.0 - u.x).powf(1.0 / (n + 1.0)), u.y)
}
// ANCHOR_END: lobe

/// The density of [`lobe`], in 1/sr, at an angle of this cosine to the axis.
pub fn lobe_pdf(cosine: f32, n: f32) -> f32 {
    if cosine > 0.0 {
        (n + 1.0) / TAU * cosine.powf(n)
    } else {
        0.0
    }
}

/// The direction at an angle of this cosine to the axis, turned around the axis by the fraction `around` of a full turn.
fn at_height(axis: Dir3, cosine: f32, around: f32) -> Dir3 {
    let (r, (sin, cos)) = (
        (1.0 - cosine * cosine).max(0.0).sqrt(),
        (TAU * around).sin_cos(),
    );
    let v = vec3(r * cos, r * sin, cosine);
    Dir3::new_or(Basis::around(axis).to_world(v), axis)
}
