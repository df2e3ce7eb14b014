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
use crate::sample::pattern::sobol::{sobol, unit};
use glam::{Vec2, vec2};
use rand::TryRng;
use rand::rand_core::utils::{fill_bytes_via_next_word, next_u64_via_u32};
use std::convert::Infallible;

/// Edge of the squares of a film whose pixels share a sequence, in pixels.
///
/// A filter or an eye averages no more pixels. Pixels that share a sequence also share its luck: of larger squares, one would be seen to be
/// noisier than the next.
const SHARED: usize = 8;

/// The binary digits of a number below [`SHARED`], with a 0 in front of each.
const SPREAD: [u32; SHARED] = [0, 0b1, 0b100, 0b101, 0b1_0000, 0b1_0001, 0b1_0100, 0b1_0101];

/// The random numbers of one sample of a pixel, pair after pair.
///
/// The first pairs of a pixel's 2ᵏ samples are 2ᵏ consecutive points of a Sobol sequence with Owen's scrambling, in a random order; so
/// are the second pairs, with another order, and so on. So the first 2ᵏ samples fill the square of each pair evenly, and the
/// points of different pairs are combined at random. Each single sample is uniform, so the estimates stay unbiased (Burley,
/// "Practical hash-based Owen scrambling", 2020).
#[derive(Clone, Debug)]
pub struct Even {
    /// The key from which all numbers of the sequence follow.
    key: u64,
    /// The sample's place in the sequence, in each of three orders of the pixels that share it.
    places: [u32; 3],
    /// A mask of the binary digits of the places in the sequence: its length, a power of two, minus 1.
    mask: u32,
    /// Number of pairs made.
    pairs: u64,
    /// The second number of the last pair, until it is used.
    second: Option<u32>,
}

impl Even {
    /// The numbers of sample `index` of `samples`, in a sequence of its own, which `key` chooses. `index` is below `samples`, and
    /// `samples` is at most 2³¹.
    #[inline]
    pub fn new(key: u64, index: usize, samples: usize) -> Self {
        Self {
            key,
            places: [index as u32; 3],
            mask: length(samples) - 1,
            pairs: 0,
            second: None,
        }
    }

    /// The numbers of sample `index` of `samples`, in the pixel of this column and row of a film with this seed. `index` is below
    /// `samples`, and `samples` is at most 2²⁶.
    ///
    /// The pixels of a square of 8 × 8 share a sequence, of which each has a piece. The pieces follow each other along Morton's curve
    /// (Morton 1966), on which 2 × 2 and 4 × 4 pixels come one after the other. So if a pixel takes all samples, and their number is a power
    /// of two, the samples of such a block together fill the square of each pair evenly, too: errors that come from one pair mostly
    /// cancel, and less noise is left when an eye or a filter takes the pixels together (Ahmed and Wonka, "Screen-space blue-noise diffusion
    /// of Monte Carlo sampling error via hierarchical ordering of pixels", 2020). Errors that several pairs make together cancel less, the
    /// more samples there are. Pixels of different squares are independent.
    ///
    /// ```
    /// use raybook::sample::even::Even;
    ///
    /// // Of four pixels with one sample each, one has its sample in each quarter of the pixel.
    /// let quarter = |pixel| Even::of_pixel(7, pixel, 0, 1).pair().to_array().map(|v| v >= 0.5);
    /// let mut quarters = [[0, 0], [1, 0], [0, 1], [1, 1]].map(quarter);
    /// quarters.sort();
    /// assert_eq!(quarters, [[false, false], [false, true], [true, false], [true, true]]);
    /// ```
    #[inline]
    pub fn of_pixel(seed: u64, [x, y]: [usize; 2], index: usize, samples: usize) -> Self {
        let square = ((y / SHARED) as u64) << 32 | (x / SHARED) as u64;
        let (x, y, samples) = (x % SHARED, y % SHARED, length(samples));
        // Which of its three neighbours in a 2 × 2 block comes next to a pixel: each in one of the orders, so that no direction is preferred.
        let orders = [[x, y], [y, x], [x, x ^ y]];
        let pixels = (SHARED * SHARED) as u32;
        Self {
            key: mix(seed ^ mix(square)),
            places: orders.map(|[low, high]| {
                let before = SPREAD[low] | SPREAD[high] << 1;
                before.wrapping_mul(samples) | index as u32
            }),
            mask: samples.wrapping_mul(pixels).wrapping_sub(1),
            pairs: 0,
            second: None,
        }
    }

    /// The next pair, in [0, 1)².
    #[inline]
    pub fn pair(&mut self) -> Vec2 {
        let Ok(first) = self.try_next_u32();
        let Ok(second) = self.try_next_u32();
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
        // The places are shuffled. Each digit of the new place depends on the digits before it only: so a run of 2ᵏ places, from a multiple
        // of 2ᵏ on, stays such a run, and a pixel, or a block of pixels, stays even. The mask keeps the place in the sequence.
        let place = self.places[(order >> 32) as usize % 3];
        let place = scramble(place, order as u32) & self.mask;
        let [x, y] = sobol(place);
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

/// The length of the piece of a sequence that a pixel's samples take: their number, rounded up to a power of two.
#[inline]
fn length(samples: usize) -> u32 {
    (samples.min(1 << 31) as u32).next_power_of_two()
}

/// A scramble like [`owen::scramble`](crate::sample::pattern::owen::scramble), but for all digits at once. A product carries
/// digits only to higher places, so each digit of the mirrored number depends only on lower digits and on the key (Laine and
/// Karras 2011, with the constants of Vegdahl, "Building a better LK hash", 2021).
#[inline]
pub(crate) fn scramble(bits: u32, key: u32) -> u32 {
    let mut x = bits.reverse_bits();
    x ^= x.wrapping_mul(0x3d20_adea);
    x = x.wrapping_add(key);
    x = x.wrapping_mul((key >> 16) | 1);
    x ^= x.wrapping_mul(0x0552_6c56);
    x ^= x.wrapping_mul(0x53a2_2864);
    x.reverse_bits()
}
