//! The angle as a sum of equal steps of u = 1/r, from far away to the turning point.

use std::f64::consts::PI;

/// u at the turning point, the least u > 0 with u² − u³ = 1/b².
fn turning_point(b: f64) -> f64 {
    let (mut low, mut high) = (0.0, 2.0 / 3.0);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if middle * middle * (1.0 - middle) < 1.0 / (b * b) {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

/// The angle by the integrand 1/√(1/b² − u² + u³) in the middles of this number of steps.
pub(super) fn sum(b: f64, count: u32) -> f64 {
    let step = turning_point(b) / f64::from(count);
    let integrand = |u: f64| (1.0 / (b * b) - u * u + u * u * u).sqrt().recip();
    let middles = (0..count).map(|i| (f64::from(i) + 0.5) * step);
    2.0 * step * middles.map(integrand).sum::<f64>() - PI
}

/// The number of steps, a round one, whose sum loses this of the angle.
///
/// Before the turning point u₀ the integrand grows as 1/√(u₀ (2 − 3 u₀) (u₀ − u)), and n steps on the way there and n on the way back lose
/// 2c/√(n (2 − 3 u₀)). Of the values in the middles of the steps c is −ζ(½, ½), of those at their beginnings −ζ(½); these have half a step too much
/// at the other end, where the integrand is b.
pub(super) fn count_that_loses(b: f64, lost: f64) -> Option<f64> {
    /// c, and how many halves of a step are too much.
    const RULES: [(f64, f64); 2] = [(0.604_898_6, 0.0), (1.460_354_5, 1.0)];
    if lost <= 0.0 {
        return None;
    }
    let turns = turning_point(b);
    let count = |(c, halves): (f64, f64)| {
        let losing = |lost: f64| (2.0 * c / lost).powi(2) / (2.0 - 3.0 * turns);
        let better = |count, _| losing(lost + halves * b * turns / count);
        (0..4).fold(losing(lost), better)
    };
    RULES.into_iter().find_map(|rule| round(count(rule)))
}

/// The number of one digit and zeros, or the power of two, that a number of steps nearly is.
fn round(count: f64) -> Option<f64> {
    /// By which share the number may be off, as far as the law holds.
    const NEARLY: f64 = 2e-3;
    let ten = 10.0_f64.powf(count.log10().floor());
    let round = [ten * (count / ten).round(), count.log2().round().exp2()];
    let is_near = |round: &f64| *round >= 10.0 && (count / round - 1.0).abs() < NEARLY;
    round.into_iter().find(is_near)
}
