//! Smooth random functions, for patterns such as clouds, waves and wood.
//!
//! ```
//! use glam::vec2;
//! use raybook::scene::noise::noise;
//!
//! // A random number at whole coordinates, and nearly the same number close by.
//! assert_ne!(noise(vec2(3.0, 7.0)), noise(vec2(4.0, 7.0)));
//! assert!((noise(vec2(3.0, 7.0)) - noise(vec2(3.01, 7.0))).abs() < 0.01);
//! ```

use crate::math::whole::below;
use glam::Vec2;

/// A smooth random function of the plane, in [0, 1]: random at whole coordinates, blended between them
/// (value noise, after Perlin, "An image synthesizer", 1985).
pub fn noise(p: Vec2) -> f32 {
    let (i, j) = (below(p.x), below(p.y));
    let corner = |x, y| hash(i.wrapping_add(x), j.wrapping_add(y));
    let f = p - Vec2::new(i as f32, j as f32);
    let blend = f * f * (3.0 - 2.0 * f);
    let across = |y: i32| corner(0, y) + (corner(1, y) - corner(0, y)) * blend.x;
    across(0) + (across(1) - across(0)) * blend.y
}

/// The sum of `count` layers of noise, each twice as fine and half as strong as the layer before, scaled to [0, 1] (fractal
/// noise). `count` is at least 1.
pub fn layers(p: Vec2, count: u32) -> f32 {
    /// Turns by 37° and doubles, so that the lattices of the layers do not coincide.
    const FINER: Vec2 = Vec2::new(1.6, 1.2);
    let (mut sum, mut weight, mut strength, mut place) = (0.0, 0.0, 1.0, p);
    for _ in 0..count {
        sum += strength * noise(place);
        weight += strength;
        strength *= 0.5;
        place = FINER.rotate(place) + 17.3;
    }
    sum / weight
}

/// A random number in [0, 1] for a pair of whole numbers.
pub fn hash(x: i32, y: i32) -> f32 {
    let mut h = (x as u32).wrapping_mul(0x9e37_79b1) ^ (y as u32).wrapping_mul(0x85eb_ca77);
    h = (h ^ (h >> 15)).wrapping_mul(0x2c1b_3c6d);
    h = (h ^ (h >> 12)).wrapping_mul(0x297a_2d39);
    (h ^ (h >> 15)) as f32 / u32::MAX as f32
}

/// A smooth step: 0 up to `from`, 1 from `to` on, and 3f² − 2f³ at the fraction f between. `from` may be greater than `to`.
pub fn rise(from: f32, to: f32, x: f32) -> f32 {
    let f = ((x - from) / (to - from)).clamp(0.0, 1.0);
    f * f * (3.0 - 2.0 * f)
}
