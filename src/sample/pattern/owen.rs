//! Sobol's points with Owen's scrambling.
//!
//! ```
//! use raybook::math::pcg;
//! use raybook::sample::pattern::owen::sobol_owen;
//!
//! // The mean of x·y over the square is 1/4. 64 points find it to 1 %.
//! let points = sobol_owen(64, &mut pcg::stream(1, 0));
//! let mean = points.iter().map(|p| p.x * p.y).sum::<f32>() / 64.0;
//! assert!((mean - 0.25).abs() < 0.0025);
//! ```

use crate::math::pcg::{Pcg, mix};
use crate::sample::pattern::sobol::sobol;
use glam::{Vec2, vec2};
use rand::RngExt;

/// Number of binary digits that are kept: an `f32` has 24, and with more digits a number could round to 1.
const DIGITS: u32 = 24;

/// The first n points of Sobol's sequence, each coordinate scrambled.
///
/// The mean of a function over the points is unbiased, and for a smooth function its error falls like n^−3/2 (Owen 1997).
pub fn sobol_owen(n: usize, rng: &mut Pcg) -> Vec<Vec2> {
    (0..n as u32).map(sequence(rng)).collect()
}

/// The points of a scrambled Sobol sequence, as a function of the point's number: most pixels of an adaptive picture need only a
/// few.
fn sequence(rng: &mut Pcg) -> impl Fn(u32) -> Vec2 + use<> {
    let seeds: [u64; 2] = [rng.random(), rng.random()];
    let along = |bits, seed| (scramble(bits, seed) >> (32 - DIGITS)) as f32 / (1 << DIGITS) as f32;
    move |i| {
        let [x, y] = sobol(i);
        vec2(along(x, seeds[0]), along(y, seeds[1]))
    }
}

// ANCHOR: owen
/// Owen's scrambling: a coin decides whether to exchange the halves of [0, 1); then, for each half, another coin decides whether
/// to exchange its halves, and so on (Owen, "Randomly permuted (t, m, s)-nets and (t, s)-sequences", 1995). `bits` is the number
/// in units of 2⁻³².
///
/// The digits before a digit tell the number's piece, and so which coin decides about the digit. Points in different pieces stay
/// in different pieces: a net stays a net.
pub fn scramble(bits: u32, seed: u64) -> u32 {
    (0..DIGITS).fold(bits, |scrambled, digit| {
        let piece = (1 << digit) | (u64::from(bits) >> (32 - digit)); // the 1 says how many digits follow
        let coin = mix(seed ^ piece) as u32 & 1;
        scrambled ^ (coin << (31 - digit))
    })
}
// ANCHOR_END: owen
