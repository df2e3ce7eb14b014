//! The number by which something on the way to the wrong answers was multiplied, or that was added to it, if it is one that nobody thought of.

use crate::diagnose::evidence::Evidence;

/// A number nearer to 1 than this is no mistake …
const NONE: f64 = 1e-3;

/// … nor is a smaller number that is added …
const LEAST: f64 = 1e-5;

/// … and nobody makes a value this many times as large, or as small.
const MOST: f64 = 1e3;

/// The factor with few digits that explains the first wrong answer, the last, and one between; `answer` is given a number and that of an
/// item.
pub fn factor(
    evidence: &Evidence<'_>,
    answer: &dyn Fn(f64, usize) -> Option<Vec<f64>>,
) -> Option<f64> {
    let by = fitting(evidence, answer, 1.0, moved)?;
    ((by - 1.0).abs() > NONE && (1.0 / MOST..MOST).contains(&by.abs())).then_some(by)
}

/// The same of a summand.
pub fn summand(
    evidence: &Evidence<'_>,
    answer: &dyn Fn(f64, usize) -> Option<Vec<f64>>,
) -> Option<f64> {
    let more = fitting(evidence, answer, 0.0, |more, step| more - step)?;
    (LEAST..MOST).contains(&more.abs()).then_some(more)
}

/// Finds the number, from one with which nothing changes; `moved` is a number less a step.
fn fitting(
    evidence: &Evidence<'_>,
    answer: &dyn Fn(f64, usize) -> Option<Vec<f64>>,
    from: f64,
    moved: fn(f64, f64) -> f64,
) -> Option<f64> {
    let off = |by: f64| off(&evidence.items[0].got, &answer(by, 0)?);
    let by = nearest(&off, from, moved)?;
    let few = [0, evidence.wrong / 2, evidence.wrong - 1];
    let explains = |by: &f64| {
        let explains = |k: usize| answer(*by, k).is_some_and(|one| evidence.explains(k, &one));
        few.into_iter().all(explains)
    };
    // Who writes a number writes few digits.
    let mut written = [1, 2, 3].into_iter().map(|digits| rounded(by, digits));
    written.find(|by| *by != from && explains(by))
}

/// How far an answer is from another of the same length; none if that is endless.
fn off(got: &[f64], answer: &[f64]) -> Option<Vec<f64>> {
    let off: Vec<_> = answer.iter().zip(got).map(|(a, b)| a - b).collect();
    let is_one = answer.len() == got.len() && off.iter().all(|v| v.is_finite());
    is_one.then_some(off)
}

/// The number with which least is left of what an answer is off, by Newton's method for least squares.
fn nearest(
    off: &dyn Fn(f64) -> Option<Vec<f64>>,
    from: f64,
    moved: fn(f64, f64) -> f64,
) -> Option<f64> {
    /// The difference by which a slope is measured: that of numbers in single precision.
    const BESIDE: f64 = 1e-3;
    const ROUNDS: usize = 12;
    let mut by = from;
    for _ in 0..ROUNDS {
        let (here, beside) = (off(by)?, off(by + BESIDE)?);
        let slopes = here.iter().zip(&beside);
        let slopes: Vec<_> = slopes
            .map(|(here, beside)| (beside - here) / BESIDE)
            .collect();
        let steep: f64 = slopes.iter().map(|v| v * v).sum();
        if steep == 0.0 {
            return None;
        }
        let down: f64 = here
            .iter()
            .zip(&slopes)
            .map(|(off, slope)| off * slope)
            .sum();
        by = moved(by, (down / steep).clamp(-1.0, 1.0));
    }
    Some(by)
}

/// A number less a step, but no nearer to 0 than half of it: of what nearly vanishes, such as the distance between points, an answer is
/// endlessly long.
fn moved(by: f64, step: f64) -> f64 {
    let next = by - step;
    let least = 0.5 * by.abs();
    if next.abs() < least {
        least.copysign(next)
    } else {
        next
    }
}

/// A number with this many digits behind the first.
fn rounded(v: f64, digits: i32) -> f64 {
    let scale = 10.0_f64.powf(f64::from(digits) - v.abs().log10().floor());
    (v * scale).round() / scale
}
