//! Random numbers by a pattern of the unit square: a set of its points for each pair of numbers.
//!
//! ```
//! use rand::RngExt;
//! use raybook::math::pcg;
//! use raybook::sample::{padded::Padded, pattern::regular_grid::regular_grid};
//!
//! // The third numbers of four samples, by a grid of 2 × 2 that is moved: two values, half of the square apart.
//! let mut rng = pcg::stream(7, 0);
//! let mut padded = Padded::new(&mut rng, |_| regular_grid(2, 2));
//! let third = [0, 1, 2, 3].map(|i| padded.sample(i).random::<[f32; 3]>()[2]);
//! let half = third.map(|x| (2.0 * (x - third[0])).abs());
//! assert_eq!(half.iter().filter(|x| x.round() == 1.0).count(), 2);
//! assert!(half.iter().all(|x| (x - x.round()).abs() < 1e-5));
//! ```

use crate::math::pcg::Pcg;
use glam::{Vec2, vec2};
use rand::rand_core::utils::{fill_bytes_via_next_word, next_u64_via_u32};
use rand::seq::SliceRandom;
use rand::{RngExt, TryRng};
use std::convert::Infallible;

/// The random numbers of all samples of a pixel, pair after pair, by sets of points.
///
/// The k-th pairs of the samples are one set of points in a random order, so the samples fill the square of each pair evenly. Each
/// pair has a set of its own, in an order of its own, so one pair says nothing about another (padding: Kollig and Keller,
/// "Efficient multidimensional sampling", 2002). Each set is moved by a random vector, around the edges of the square, because the
/// points of some patterns are always the same (Cranley and Patterson, "Randomization of number theoretic methods for multiple
/// integration", 1976): so each single number is uniform, and estimates stay unbiased.
#[derive(Debug)]
pub struct Padded<'a, F> {
    rng: &'a mut Pcg,
    points: F,
    /// The set of each pair that a sample has asked for.
    sets: Vec<Vec<Vec2>>,
}

impl<'a, F: Fn(&mut Pcg) -> Vec<Vec2>> Padded<'a, F> {
    /// Of sets that `points` places; all randomness comes from `rng`.
    pub fn new(rng: &'a mut Pcg, points: F) -> Self {
        Self {
            rng,
            points,
            sets: Vec::new(),
        }
    }

    /// The numbers of sample i, from the first pair on.
    pub fn sample(&mut self, i: usize) -> Numbers<'_, 'a, F> {
        Numbers {
            padded: self,
            sample: i,
            pairs: 0,
            second: None,
        }
    }

    /// The k-th pair of sample i.
    fn pair(&mut self, k: usize, i: usize) -> Vec2 {
        while self.sets.len() <= k {
            let set = self.set();
            self.sets.push(set);
        }
        // A sample that has no point gets a random one.
        match self.sets[k].get(i) {
            Some(point) => *point,
            None => vec2(self.rng.random(), self.rng.random()),
        }
    }

    /// A new set, moved and shuffled.
    fn set(&mut self) -> Vec<Vec2> {
        let mut set = (self.points)(self.rng);
        let by = vec2(self.rng.random(), self.rng.random());
        for point in &mut set {
            *point = (*point + by).fract();
        }
        set.shuffle(self.rng);
        set
    }
}

/// The random numbers of one sample of a pixel.
#[derive(Debug)]
pub struct Numbers<'p, 'a, F> {
    padded: &'p mut Padded<'a, F>,
    sample: usize,
    /// Number of pairs made.
    pairs: usize,
    /// The second number of the last pair, until it is used.
    second: Option<f32>,
}

impl<F: Fn(&mut Pcg) -> Vec<Vec2>> TryRng for Numbers<'_, '_, F> {
    type Error = Infallible;

    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        let number = if let Some(second) = self.second.take() {
            second
        } else {
            let point = self.padded.pair(self.pairs, self.sample);
            self.pairs += 1;
            self.second = Some(point.y);
            point.x
        };
        Ok((f64::from(number) * 2_f64.powi(32)) as u32)
    }

    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        next_u64_via_u32(self)
    }

    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
        fill_bytes_via_next_word(bytes, || self.try_next_u32())
    }
}
