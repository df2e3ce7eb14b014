//! Chapter 23: when to look again, and where.

use crate::alternatives::student::{Alternative, Answer, Question};
use glam::DVec3;

pub const ALTERNATIVES: &[Alternative] = &[
    Alternative {
        exercise: "needs_more",
        method: "the variance by the mean of the squares, in f64",
        answer: |q| {
            let (limits, error) = (q.vector(), q.number());
            let samples = q.list(Question::vector);
            let n = samples.len() as f64;
            if n < 2.0 {
                return Some(vec![1.0]);
            }
            let max = samples.iter().copied().fold(DVec3::ZERO, DVec3::max);
            let min = samples.iter().copied().fold(DVec3::INFINITY, DVec3::min);
            let sum = (max + min).max(DVec3::splat(1e-300));
            let y: Vec<_> = samples
                .iter()
                .map(|s| s.dot(DVec3::new(0.2126, 0.7152, 0.0722)))
                .collect();
            let mean = y.iter().sum::<f64>() / n;
            let variance = (y.iter().map(|y| y * y).sum::<f64>() - n * mean * mean) / (n - 1.0);
            let more =
                ((max - min) / sum).cmpgt(limits).any() || (variance.max(0.0) / n).sqrt() > error;
            Some(vec![f64::from(u8::from(more))])
        },
    },
    Alternative {
        exercise: "spend_budget",
        method: "in proportion, but not below the least, largest remainders first",
        answer: |q| {
            let deviations = q.list(Question::number);
            let (least, budget) = (q.number(), q.number());
            // The factor with which max(least, factor · σ) spend the budget, by bisection.
            let spent = |factor: f64| {
                deviations
                    .iter()
                    .map(|d| (factor * d).max(least))
                    .sum::<f64>()
            };
            let (mut low, mut high) = (0.0, 1e9);
            for _ in 0..200 {
                let middle = 0.5 * (low + high);
                if spent(middle) > budget {
                    high = middle;
                } else {
                    low = middle;
                }
            }
            round(
                &deviations
                    .iter()
                    .map(|d| (low * d).max(least))
                    .collect::<Vec<_>>(),
                budget,
            )
        },
    },
];

/// Whole numbers near these, with that sum.
fn round(counts: &[f64], budget: f64) -> Answer {
    let mut whole: Vec<_> = counts.iter().map(|n| n.floor()).collect();
    let mut order: Vec<_> = (0..counts.len()).collect();
    order.sort_by(|i, j| counts[*j].fract().total_cmp(&counts[*i].fract()));
    let left = (budget - whole.iter().sum::<f64>()) as usize;
    (0..left).for_each(|i| whole[order[i % order.len()]] += 1.0);
    Some([vec![counts.len() as f64], whole].concat())
}
