//! Whether places on the light are chosen a little too often on one side, at its borders or at its corners, strips at its edges are left out, or
//! samples counted that are not due: no single fraction shows it, and all of many answers do.

mod filter;
mod strips;

use super::fractions::{FINE, seen_places, solid_angles};
use crate::Verdict;
use crate::cases::ch16_soft_shadows::lattice;
use crate::together::{Bounds, scattered};
use filter::Filter;
use glam::{DVec2, Vec3, vec3};
use raybook_workbook::exercises::ch16_soft_shadows::{Ball, VisibleFraction};
use std::collections::BTreeMap;
use std::ops::Range;

/// The standard deviation of what the lattice that stands for the exact value is off.
const LATTICE: f64 = 0.004;

/// What may be slightly wrong: with the places on the light, in the order of [`fraction_and_leanings`]; and with the fractions, that they are some share too
/// large, or that some share of what is hidden is taken for seen.
const LEANINGS: [&str; 8] = [
    "the far side of the light along a were chosen too",
    "the far side of the light along b were chosen too",
    "the borders of the light along a were chosen too",
    "the borders of the light along b were chosen too",
    "the ends of a diagonal of the light were chosen too",
    "samples near to the point were counted too",
    "a sample that is seen were counted too",
    "a sample that is hidden were counted too",
];

/// Fractions nearer to 0 and 1 are not distributed normally.
const BETWEEN: Range<f64> = 0.02..0.98;

/// A fraction that was answered.
struct Point {
    /// The number of its question, and its place among the points of that.
    of: [usize; 2],
    /// By how much it is larger where something is slightly wrong, in the order of [`LEANINGS`].
    directions: [f64; LEANINGS.len()],
    /// By how much it is off.
    off: f64,
    /// Its variance, if all its samples are random.
    variance: f64,
    /// The fraction that is right.
    fraction: f64,
    /// Of each place of the lattice on the light, whether it is seen.
    seen: Vec<bool>,
    samples: f64,
}

/// Who takes the same random numbers again is off to the same side again: which fractions may have the same ones. All at the same place in their
/// questions; all of a question; all of them.
const SHARED: [fn(&Point) -> [usize; 2]; 3] = [
    |point| [0, point.of[1]],
    |point| [point.of[0], 0],
    |_| [0, 0],
];

/// What is slightly wrong shifts each fraction a little, in a direction that is known: the sum of all fractions' shares in that direction is
/// normally distributed (the score test, Rao 1948). Each of the eight is beyond its bound by chance with 4e-10. Where fractions may have the same random
/// numbers, the sum has the largest of the variances that it can have by them.
///
/// So it is for strips that are left out at the light's edges. Each of these eleven sums is above its bound by chance with 2e-10: 2.2e-9 in all, and
/// 5.4e-9 with the eight.
///
/// The weights are those of a [`Filter`], Σ r b/σ² for fractions r with random numbers of their own. Simulated for 107 random questions, strips of 0.05
/// at one edge, at two or on all sides are 17 to 29 standard deviations off there. If each answer has the same random numbers they are 6 to 9 off, so
/// that a strip at one edge may hide.
///
/// Fractions with random numbers of their own may scatter no more than the samples that are asked for let them: with 1e-9 they do by chance.
///
/// # Errors
/// What the fractions lean to most, if that is beyond its bound; which strips seem to be left out; or that the fractions scatter too much.
pub(super) fn together(answers: &[(VisibleFraction, Vec<f32>)], bounds: Bounds) -> Verdict {
    const DEVIATIONS: f64 = 6.25;
    let points = points(answers);
    let independent = are_independent(answers);
    let bound = bounds.of(DEVIATIONS);
    let filter = Filter::new(&points, independent);
    let by_one = excess(&points);
    let by = |biases| deviations(&points, &filter.weights(biases), independent, bound) / by_one;
    let leaning = |(i, what)| {
        let directions = points.iter().map(|point| point.directions[i]).collect();
        let by = by(directions);
        let how = if by > 0.0 { "often" } else { "seldom" };
        (
            by.abs(),
            format!("{what} {how}"),
            "which chance does not explain",
        )
    };
    let leanings = LEANINGS.into_iter().enumerate().map(leaning);
    let left_out = strips::biases(&points).into_iter().map(|(what, biases)| {
        let words = format!("{what} were left out");
        (by(biases), words, "which is no chance")
    });
    let all = leanings.chain(left_out);
    let most = all.max_by(|(a, ..), (b, ..)| a.total_cmp(b));
    let Some((by, what, why)) = most.filter(|(by, ..)| *by > bound) else {
        let by = |point: &Point| point.off / point.variance.sqrt();
        let own = points.iter().filter(|_| independent).map(by);
        return scattered("the fractions", own, bounds);
    };
    Err(format!(
        "the fractions are as if {what}: by {by:.1} standard deviations, {why}"
    ))
}

/// How many times as much as chance lets them the fractions are off, the root of the mean square, where that is clearly more: fractions of too few
/// samples lean to all sides.
fn excess(points: &[Point]) -> f64 {
    const CLEARLY: f64 = 2.0;
    let squares = points
        .iter()
        .map(|point| point.off.powi(2) / point.variance);
    let mean = squares.sum::<f64>() / points.len().max(1) as f64;
    if mean > CLEARLY * CLEARLY {
        mean.sqrt()
    } else {
        1.0
    }
}

/// By how many standard deviations the weighted sum of what the fractions are off differs from 0. Where fractions may have the same random numbers and
/// it is beyond the bound, it has the largest of its variances.
fn deviations(points: &[Point], weights: &[f64], independent: bool, bound: f64) -> f64 {
    let weighted = || points.iter().zip(weights);
    let sum: f64 = weighted().map(|(point, weight)| weight * point.off).sum();
    let by = |variance: f64| sum / variance.max(f64::MIN_POSITIVE).sqrt();
    let own = weighted().map(|(point, weight)| weight * weight * point.variance);
    let mut least = by(own.sum());
    // Most sums are within the bound of the variance that takes least to calculate.
    for group in SHARED {
        if independent || least.abs() <= bound {
            break;
        }
        let by = by(variance(points, weights, group));
        if by.abs() < f64::abs(least) {
            least = by;
        }
    }
    least
}

/// The fractions of the answers that tell something.
fn points(answers: &[(VisibleFraction, Vec<f32>)]) -> Vec<Point> {
    let of_cases = answers.iter().filter(|(q, _)| q.samples > AGAIN);
    let mut points = Vec::new();
    for (question, (q, got)) in of_cases.enumerate() {
        let seen = seen_places(q);
        for (place, (seen, got)) in seen.into_iter().zip(got).enumerate() {
            let [f, a, b, borders_a, borders_b, diagonal] = fraction_and_leanings(&seen);
            let near = by_nearness(q, q.points[place], &seen);
            if !BETWEEN.contains(&f) {
                continue;
            }
            let samples = f64::from(q.samples);
            points.push(Point {
                of: [question, place],
                directions: [a, b, borders_a, borders_b, diagonal, near, f, 1.0 - f],
                off: f64::from(*got) - f,
                fraction: f,
                variance: f * (1.0 - f) / samples + LATTICE * LATTICE,
                seen,
                samples,
            });
        }
    }
    points
}

/// The variance of the weighted sum, if fractions have the same random numbers that `group` puts together.
fn variance(points: &[Point], weights: &[f64], group: fn(&Point) -> [usize; 2]) -> f64 {
    let mut groups: BTreeMap<_, Vec<(&Point, f64)>> = BTreeMap::new();
    for (point, weight) in points.iter().zip(weights) {
        let of_group = groups.entry(group(point)).or_default();
        of_group.push((point, *weight));
    }
    let of_group = |points: &Vec<(&Point, f64)>| {
        // A sample at a place of the light adds the weights of all fractions that see it.
        let mut sums = vec![0.0; (FINE * FINE) as usize];
        for (point, weight) in points {
            let seen = sums.iter_mut().zip(&point.seen).filter(|(_, seen)| **seen);
            seen.for_each(|(sum, _)| *sum += weight);
        }
        let mean =
            |of: fn(f64) -> f64| sums.iter().map(|v| of(*v)).sum::<f64>() / sums.len() as f64;
        let scatter = mean(|v| v * v) - mean(|v| v).powi(2);
        let lattice = points.iter().map(|(_, weight)| (LATTICE * weight).powi(2));
        scatter.max(0.0) / points[0].0.samples + lattice.sum::<f64>()
    };
    groups.values().map(of_group).sum()
}

/// The fraction of a light of which these places of the lattice are seen, and by how much it is larger where places are chosen a little more often: on
/// one side along a or b, at both borders along a or b, at the ends of a diagonal.
fn fraction_and_leanings(seen: &[bool]) -> [f64; 6] {
    let mut sums = [0.0; 6];
    for (u, _) in lattice(FINE).zip(seen).filter(|(_, seen)| **seen) {
        let DVec2 { x, y } = u.as_dvec2() - 0.5;
        let weights = [1.0, x, y, x * x - 1.0 / 12.0, y * y - 1.0 / 12.0, x * y];
        sums.iter_mut().zip(weights).for_each(|(sum, w)| *sum += w);
    }
    sums.map(|sum| sum / seen.len() as f64)
}

/// By how much the fraction is larger, if each place of the lattice counts by the solid angle in which it is seen from a point.
fn by_nearness(q: &VisibleFraction, from: Vec3, seen: &[bool]) -> f64 {
    let angles = solid_angles(q, from).into_iter();
    let more = angles.zip(seen).filter(|(_, seen)| **seen);
    more.map(|(angle, _)| angle - 1.0).sum::<f64>() / seen.len() as f64
}

/// Samples of the question that is asked again and again, to see whether each fraction has random numbers of its own.
const AGAIN: u32 = 250;

/// How often it is asked.
const TIMES: usize = 8;

/// That question, whose points are one point: each time hardly another, for who takes random numbers from all that is asked.
pub(super) fn again() -> Vec<VisibleFraction> {
    let question = |i| VisibleFraction {
        corner: vec3(-1.0, 4.0, -1.0),
        a: 2.0 * Vec3::X,
        b: 2.0 * Vec3::Z,
        points: vec![Vec3::ZERO; 4],
        balls: vec![Ball {
            center: 2.0 * Vec3::Y,
            radius: 0.35 + 1e-6 * i as f32,
        }],
        samples: AGAIN,
    };
    (0..TIMES).map(question).collect()
}

/// The one of a few questions whose fractions tell most of the light's edges. It is chosen by what is right, so chance has no more to say than of others.
pub(super) fn telling(mut question: impl FnMut() -> VisibleFraction) -> VisibleFraction {
    const OTHERS: usize = 3;
    let mut best = question();
    let mut most = strips::told(&best);
    for _ in 0..OTHERS {
        let other = question();
        let by = strips::told(&other);
        if by > most {
            (best, most) = (other, by);
        }
    }
    best
}

/// Whether no two answers to that question are alike, nor the fractions of its points: each has random numbers of its own.
fn are_independent(answers: &[(VisibleFraction, Vec<f32>)]) -> bool {
    let again = answers.iter().filter(|(q, _)| q.samples == AGAIN);
    let again: Vec<_> = again.map(|(_, got)| got).collect();
    let is_new = |i: usize| !again[..i].contains(&again[i]);
    let is_shared = |got: &&Vec<f32>| got.windows(2).all(|two| two[0] == two[1]);
    again.len() >= TIMES && (0..again.len()).all(is_new) && !again.iter().any(is_shared)
}
