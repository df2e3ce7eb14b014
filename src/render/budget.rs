//! A given number of samples, shared out among pixels.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// A pixel, and what one more sample would take off its variance.
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
    /// The largest gain is the greatest; of equal ones, the first pixel, so that the result is always the same.
    fn cmp(&self, other: &Self) -> Ordering {
        let by_gain = self.gain.total_cmp(&other.gain);
        by_gain.then(other.pixel.cmp(&self.pixel))
    }
}

// ANCHOR: spend_budget
/// How many samples each pixel gets of `budget`, at least `least` each, so that Σ σ²/n is as small as it can be.
///
/// σ are the standard deviations of the pixels' samples. The n are then about in proportion to them (Neyman 1934), and
/// exactly right if each sample in turn goes where it takes off most, σ²/n − σ²/(n + 1) (Fox 1966). If the budget is not
/// enough for the least, the least it is.
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

/// The samples that take off at least a limit each, with the lowest limit that the budget allows: nearly all of them, found
/// without asking for one after the other.
///
/// Sample n takes off σ²/((n − 1) n), which is the limit for n = ½ + √(¼ + σ²/limit).
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
