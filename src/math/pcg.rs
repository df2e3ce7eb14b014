//! The random number generator, with one stream per pixel.
//!
//! ```
//! use rand::RngExt;
//! use raybook::math::pcg;
//!
//! let number = |pixel| pcg::stream(7, pixel).random::<f32>();
//! assert_eq!(number(0), number(0)); // the same stream, the same numbers
//! assert_ne!(number(0), number(1)); // each pixel has its own
//! ```

/// The generator of all random numbers in this course: PCG-XSH-RR, with 64 bits of state (O'Neill 2014).
///
/// Its numbers are the same on every machine and in every version, which `StdRng` does not promise.
pub type Pcg = rand_pcg::Pcg32;

// ANCHOR: stream
/// The generator of stream number `stream`, for example a pixel's, for the seed `seed`.
///
/// Each stream depends on these two numbers only, so a picture is the same whichever thread draws which pixel.
/// Both numbers are mixed first: neighbouring pixels must not start with similar states.
pub fn stream(seed: u64, stream: u64) -> Pcg {
    Pcg::new(mix(seed ^ mix(stream)), stream)
}
// ANCHOR_END: stream

/// `SplitMix64`'s finaliser (Steele, Lea and Flood 2014): a change of any input bit changes about half of the output bits.
#[inline]
pub fn mix(x: u64) -> u64 {
    let x = x.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}
