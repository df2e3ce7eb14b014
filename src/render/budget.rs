//! A given number of samples, distributed among pixels.
//!
//! ```
//! use raybook::render::budget::spend_budget;
//!
//! // A pixel with three times the standard deviation gets three times the samples.
//! assert_eq!(spend_budget(&[0.1, 0.3, 0.0], 1, 41), [10, 30, 1]);
//! ```

use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// A pixel, and by how much one more sample would reduce the variance of its mean.
#[derive(PartialEq)]
struct Gain {
    gain: f32,
    pixel: usize,
}

impl Eq for Gain {}

impl PartialOrd for Gain {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Gain {
    /// Orders by gain; of equal gains, the first pixel is the greatest, so that the result is always the same.
    fn cmp(&self, other: &Self) -> Ordering {
        let by_gain = self.gain.total_cmp(&other.gain);
        by_gain.then(other.pixel.cmp(&self.pixel))
    }
}

// ANCHOR: spend_budget
/// The number n of samples for each pixel, at least `least` each and `budget` in all, for which Σ σ²/n is smallest.
///
/// σ is the standard deviation of a pixel's samples, from `deviations`. The best n is about proportional to σ (Neyman 1934). It
/// is exact if the samples are given away one by one, each to the pixel where it reduces the sum most, by σ²/n − σ²/(n + 1) (Fox
/// 1966). If the budget is too small, each pixel still gets `least` samples, and at least 1.
pub fn spend_budget(deviations: &[f32], least: u32, budget: u32) -> Vec<u32> {
    let least = least.max(1);
    let mut counts = most_worthwhile(deviations, least, budget);
    let gain = |pixel: usize, n: u32| {
        let n = n as f32;
        Gain {
            gain: deviations[pixel] * deviations[pixel] / (n * (n + 1.0)),
            pixel,
        }
    };
    let pixels = counts.iter().enumerate();
    let mut gains: BinaryHeap<_> = pixels.map(|(pixel, n)| gain(pixel, *n)).collect();
    let spent: u64 = counts.iter().map(|n| u64::from(*n)).sum();
    for _ in spent..u64::from(budget) {
        let Some(Gain { pixel, .. }) = gains.pop() else {
            break;
        };
        counts[pixel] += 1;
        gains.push(gain(pixel, counts[pixel]));
    }
    counts
}
// ANCHOR_END: spend_budget

/// The number of samples per pixel that each reduce the sum by at least a limit, with the lowest limit that the budget allows:
/// nearly all samples of the budget, found without giving them away one by one.
///
/// Sample n reduces the sum by σ²/((n − 1) n), which equals the limit for n = ½ + √(¼ + σ²/limit).
fn most_worthwhile(deviations: &[f32], least: u32, budget: u32) -> Vec<u32> {
    let squares = || deviations.iter().map(|d| f64::from(*d).powi(2));
    let counts = |limit: f64| squares().map(move |s| (0.5 + (0.25 + s / limit).sqrt()) as u32);
    let affordable = |limit: f64| {
        let all: u64 = counts(limit).map(|n| u64::from(n.max(least))).sum();
        all <= u64::from(budget)
    };
    let (mut low, mut high) = (0.0, squares().fold(0.0, f64::max));
    if !(high.is_finite() && affordable(high)) {
        return vec![least; deviations.len()];
    }
    for _ in 0..64 {
        let middle = 0.5 * (low + high);
        if affordable(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    counts(high).map(|n| n.max(least)).collect()
}
