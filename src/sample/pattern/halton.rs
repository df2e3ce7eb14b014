//! Halton's sequence.
//!
//! ```
//! use raybook::sample::pattern::halton::radical_inverse;
//!
//! assert_eq!([1, 2, 3, 4].map(|i| radical_inverse(2, i)), [0.5, 0.25, 0.75, 0.125]);
//! ```

use crate::math::pcg::Pcg;
use glam::{Vec2, vec2};
use rand::RngExt;

// ANCHOR: halton
/// The first n points (φ₂(i), φ₃(i)) of Halton's sequence (1960), all shifted by the same random vector. A point that leaves the
/// square enters it again on the other side (Cranley and Patterson 1976).
pub fn halton(n: usize, rng: &mut Pcg) -> Vec<Vec2> {
    let shift: [f64; 2] = [rng.random(), rng.random()];
    let along =
        |base: u64, i: u64, shift: f64| below_one((radical_inverse(base, i) + shift).fract());
    (0..n as u64)
        .map(|i| vec2(along(2, i, shift[0]), along(3, i, shift[1])))
        .collect()
}
// ANCHOR_END: halton

// ANCHOR: radical_inverse
/// The radical inverse φ_b(i): the digits of i in the base b, mirrored at the point; 6 = 110₂ becomes 0.011₂ = 3/8 (van der
/// Corput's sequence). `base` is at least 2.
///
/// Of any bᵏ consecutive numbers, there is one in each of bᵏ equal parts of [0, 1).
///
/// # Panics
/// If `base` is 0 and i is not.
pub fn radical_inverse(base: u64, mut i: u64) -> f64 {
    let (mut mirrored, mut digit) = (0.0, 1.0);
    while i > 0 {
        digit /= base as f64;
        mirrored += digit * (i % base) as f64;
        i /= base;
    }
    mirrored
}
// ANCHOR_END: radical_inverse

/// The number as an `f32`, but below 1 even if it would be rounded up to 1.
pub fn below_one(x: f64) -> f32 {
    (x as f32).min(1.0_f32.next_down())
}
