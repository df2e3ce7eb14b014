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
fn scramble(bits: u32, key: u32) -> u32 {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_in_different_pieces_stay_in_different_pieces_and_each_piece_goes_everywhere() {
        for digits in 1..8 {
            for key in [1, 77, 0xdead_beef] {
                let piece = |i: u32| scramble(i << (32 - digits), key) >> (32 - digits);
                let mut pieces: Vec<_> = (0..1 << digits).map(piece).collect();
                pieces.sort_unstable();
                assert!(pieces.into_iter().eq(0..1 << digits), "{digits} digits");
            }
        }
        let mean = |bits| {
            (0..1000)
                .map(|key| f64::from(scramble(bits, mix(key) as u32)) / 2f64.powi(32))
                .sum::<f64>()
                / 1000.0
        };
        // The mean of 1000 numbers scatters by 0.009 around one half.
        assert!(
            [0, 1 << 31, 123_456_789]
                .iter()
                .all(|&bits| (mean(bits) - 0.5).abs() < 0.045)
        );
    }

    #[test]
    fn every_power_of_two_of_the_samples_fills_the_square_of_each_pair() {
        for (pixel, samples) in [(3, 4_usize), (99, 16), (12_345, 64)] {
            let numbers = |i| Even::new(mix(pixel), i, 64);
            let mut all: Vec<_> = (0..samples).map(numbers).collect();
            for pair in 0..5 {
                let points: Vec<_> = all.iter_mut().map(Even::pair).collect();
                let side = samples.isqrt();
                let mut cells: Vec<_> = points
                    .iter()
                    .map(|p| (*p * side as f32).as_uvec2())
                    .map(|c| c.x + side as u32 * c.y)
                    .collect();
                cells.sort_unstable();
                assert!(
                    cells.into_iter().eq(0..samples as u32),
                    "pair {pair} of {samples}"
                );
            }
        }
    }

    #[test]
    fn one_pair_says_nothing_about_the_next() {
        // The mean product of two pairs' deviations from one half: 0 if the pairs are independent.
        let pixels = 2000_u64;
        let mut sum = 0.0;
        for pixel in 0..pixels {
            for i in 0..16 {
                let mut numbers = Even::new(mix(pixel), i, 16);
                let (a, b) = (numbers.pair(), numbers.pair());
                sum += f64::from((a.x - 0.5) * (b.x - 0.5));
            }
        }
        // Each product scatters by 1/12, and 32000 of them together by 1/12/√32000 = 0.0005.
        assert!((sum / (16.0 * pixels as f64)).abs() < 0.0025, "{sum}");
    }
}
