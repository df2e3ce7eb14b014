//! Low-discrepancy random numbers: they are spread evenly over the samples of a pixel, which gives less noise for the same work.
//!
//! ```
//! use raybook::sample::even::Even;
//!
//! // Of the four samples of a pixel, one is in each quarter of the square.
//! let quarter = |i| Even::new(42, i, 4).pair().to_array().map(|v| v >= 0.5);
//! let mut quarters = [0, 1, 2, 3].map(quarter);
//! quarters.sort();
//! assert_eq!(quarters, [[false, false], [false, true], [true, false], [true, true]]);
//! ```

use crate::math::pcg::mix;
use crate::sample::pattern::sobol::sobol;
use glam::{Vec2, vec2};
use rand::TryRng;
use rand::rand_core::utils::{fill_bytes_via_next_word, next_u64_via_u32};
use std::convert::Infallible;

/// The random numbers of one sample of a pixel, pair after pair.
///
/// The first pairs of all samples of a pixel are the beginning of a Sobol sequence with Owen's scrambling, in a random order; so
/// are the second pairs, with another order, and so on. So the first 2ᵏ samples fill the square of each pair evenly, and the
/// points of different pairs are combined at random. Each single sample is uniform, so the estimates stay unbiased (Burley,
/// "Practical hash-based Owen scrambling", 2020).
#[derive(Clone, Debug)]
pub struct Even {
    /// The pixel's key, from which all numbers of the pixel follow.
    pixel: u64,
    /// The sample's number, from 0, with its bits mirrored.
    mirrored: u32,
    /// A mask of the binary digits that indices have: a power of two minus 1.
    digits: u32,
    /// Number of pairs made.
    pairs: u64,
    /// The second number of the last pair, until it is used.
    second: Option<u32>,
}

impl Even {
    /// The numbers of sample `index` of `samples`, in the pixel with the key `pixel`.
    #[inline]
    pub fn new(pixel: u64, index: usize, samples: usize) -> Self {
        Self {
            pixel,
            mirrored: (index as u32).reverse_bits(),
            digits: samples.next_power_of_two() as u32 - 1,
            pairs: 0,
            second: None,
        }
    }

    /// The next pair, in [0, 1)².
    #[inline]
    pub fn pair(&mut self) -> Vec2 {
        let Ok(first) = self.try_next_u32();
        let Ok(second) = self.try_next_u32();
        let unit = |bits: u32| (bits >> 8) as f32 / (1 << 24) as f32;
        vec2(unit(first), unit(second))
    }
}

impl TryRng for Even {
    type Error = Infallible;

    #[inline]
    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        if let Some(second) = self.second.take() {
            return Ok(second);
        }
        let key = |i| mix(self.pixel ^ mix(2 * self.pairs + i));
        let (order, keys) = (key(0), key(1));
        self.pairs += 1;
        // The mask keeps the index below the power of two: the samples are a permutation of this part of the sequence.
        let [x, y] = sobol(hash(self.mirrored, order as u32).reverse_bits() & self.digits);
        self.second = Some(scramble(y, (keys >> 32) as u32));
        Ok(scramble(x, keys as u32))
    }

    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        next_u64_via_u32(self)
    }

    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
        fill_bytes_via_next_word(bytes, || self.try_next_u32())
    }
}

/// A scramble like [`owen::scramble`](crate::sample::pattern::owen::scramble), but for all digits at once. A product carries
/// digits only to higher places, so each digit of the mirrored number depends only on lower digits and on the key (Laine and
/// Karras 2011, with the constants of Vegdahl, "Building a better LK hash", 2021).
#[inline]
pub(crate) fn scramble(bits: u32, key: u32) -> u32 {
    hash(bits.reverse_bits(), key).reverse_bits()
}

/// [`scramble`], of a mirrored number and with a mirrored result.
#[inline]
fn hash(mut x: u32, key: u32) -> u32 {
    x ^= x.wrapping_mul(0x3d20_adea);
    x = x.wrapping_add(key);
    x = x.wrapping_mul((key >> 16) | 1);
    x ^= x.wrapping_mul(0x0552_6c56);
    x ^ x.wrapping_mul(0x53a2_2864)
}
