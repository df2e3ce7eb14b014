//! Low-discrepancy random numbers: they are spread evenly over the samples of a pixel, and over those of neighbouring pixels, which
//! gives less noise for the same work.
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

/// Edge of the tiles of a film whose pixels share a sequence, in pixels.
const TILE: u64 = 64;

/// The random numbers of one sample of a pixel, pair after pair.
///
/// The first pairs of all samples of a pixel are the beginning of a Sobol sequence with Owen's scrambling, in a random order; so
/// are the second pairs, with another order, and so on. So the first 2ᵏ samples fill the square of each pair evenly, and the
/// points of different pairs are combined at random. Each single sample is uniform, so the estimates stay unbiased (Burley,
/// "Practical hash-based Owen scrambling", 2020).
#[derive(Clone, Debug)]
pub struct Even {
    /// The key from which all numbers of the sequence follow.
    key: u64,
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
    /// The numbers of sample `index` of `samples`, in the sequence with this key, as a pixel has one.
    #[inline]
    pub fn new(key: u64, index: usize, samples: usize) -> Self {
        Self::piece(key, index as u64, samples.next_power_of_two() as u64)
    }

    /// The same, where `samples` is a power of two.
    #[inline]
    fn piece(key: u64, index: u64, samples: u64) -> Self {
        Self {
            key,
            mirrored: (index as u32).reverse_bits(),
            digits: (samples - 1) as u32,
            pairs: 0,
            second: None,
        }
    }

    /// The numbers of sample `index` of `samples`, in the pixel of this column and row of a film with this seed.
    ///
    /// The pixels of a tile share one sequence, of which each has a piece. The pieces follow each other along Morton's curve, on which
    /// two, four, eight … pixels side by side come one after the other: so their samples together fill the square of each pair evenly,
    /// too. Where one pixel is too bright, its neighbours are too dark, and less noise is left when an eye or a filter takes them together
    /// (Ahmed and Wonka, "Screen-space blue-noise diffusion of Monte Carlo sampling error via hierarchical ordering of pixels", 2020).
    #[inline]
    pub fn of_pixel(seed: u64, [x, y]: [usize; 2], index: usize, samples: usize) -> Self {
        let [x, y, index, samples] = [x, y, index, samples].map(|n| n as u64);
        let samples = samples.next_power_of_two();
        let before = spread(x % TILE) | spread(y % TILE) << 1;
        let key = mix(seed ^ mix(((y / TILE) << 32) | (x / TILE)));
        Self::piece(key, before * samples + index, TILE * TILE * samples)
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
        let key = |i| mix(self.key ^ mix(2 * self.pairs + i));
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

/// The six binary digits of a place in a tile, with a 0 before each.
#[inline]
fn spread(place: u64) -> u64 {
    let fours = (place | place << 4) & 0x30f;
    let twos = (fours | fours << 2) & 0x333;
    (twos | twos << 1) & 0x555
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
