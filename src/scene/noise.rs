//! Smooth randomness for patterns that nobody wants to draw: clouds, waves, wood.

use glam::Vec2;

/// A smooth random function of the plane, in [0, 1]: random at whole coordinates, blended between them
/// (value noise, after Perlin, "An image synthesizer", 1985).
pub fn noise(p: Vec2) -> f32 {
    let cell = p.floor();
    let corner = |x, y| {
        hash(
            (cell.x as i32).wrapping_add(x),
            (cell.y as i32).wrapping_add(y),
        )
    };
    let f = p - cell;
    let blend = f * f * (3.0 - 2.0 * f);
    let across = |y: i32| corner(0, y) + (corner(1, y) - corner(0, y)) * blend.x;
    across(0) + (across(1) - across(0)) * blend.y
}

/// Noise in layers, each twice as fine and half as strong as the one before; in [0, 1].
pub fn layers(p: Vec2, count: u32) -> f32 {
    /// Turns and doubles, so that the lattices of the layers do not lie on each other.
    const FINER: Vec2 = Vec2::new(1.6, 1.2);
    let (mut sum, mut weight, mut place) = (0.0, 0.0, p);
    for layer in 0..count {
        let strength = 0.5_f32.powi(layer as i32);
        sum += strength * noise(place);
        weight += strength;
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

/// 0 below `from`, 1 above `to`, and a smooth rise between.
pub fn rise(from: f32, to: f32, x: f32) -> f32 {
    let f = ((x - from) / (to - from)).clamp(0.0, 1.0);
    f * f * (3.0 - 2.0 * f)
}
