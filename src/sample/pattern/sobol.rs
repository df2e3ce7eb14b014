//! Sobol's sequence in two dimensions.
//!
//! ```
//! use raybook::sample::pattern::sobol::sobol;
//!
//! // In units of 2⁻³², the first four points are in the four quarters of the square.
//! let quarters = [0, 1, 2, 3].map(|i| sobol(i).map(|v| v >> 31));
//! assert!((0..4).all(|i| !quarters[..i].contains(&quarters[i])));
//! ```

// ANCHOR: sobol
/// Point i of Sobol's sequence (1967), both coordinates in units of 2⁻³².
///
/// The first coordinate is i with its bits mirrored, as in van der Corput's sequence. The second is a sum without carry (XOR) of
/// one number for each bit of i that is 1: the rows of Pascal's triangle modulo 2. If m is a multiple of 2ᵏ, the points m to
/// m + 2ᵏ − 1 have one point in each box of the area 2⁻ᵏ whose width is any power of ½: they are a (0, k, 2)-net in base 2.
///
/// Entry k of the triangle's row n is odd if every binary digit that is 1 in k is also 1 in n (Lucas 1878). So five steps, one
/// for each binary digit of a bit's place, add the rows of all bits at once, without a loop or a branch.
#[inline]
pub fn sobol(i: u32) -> [u32; 2] {
    let mut sum = i;
    sum ^= sum >> 1 & 0x5555_5555;
    sum ^= sum >> 2 & 0x3333_3333;
    sum ^= sum >> 4 & 0x0f0f_0f0f;
    sum ^= sum >> 8 & 0x00ff_00ff;
    sum ^= sum >> 16;
    [i.reverse_bits(), sum.reverse_bits()]
}
// ANCHOR_END: sobol

/// The 24 highest binary digits as a number in [0, 1): an `f32` has no more, and with more the number could round to 1.
#[inline]
pub(crate) fn unit(bits: u32) -> f32 {
    (bits >> 8) as f32 / (1 << 24) as f32
}
