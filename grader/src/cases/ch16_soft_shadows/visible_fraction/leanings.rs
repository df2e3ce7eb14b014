//! Whether places on the light are chosen a little too often on one side, at its borders or at its corners, or samples counted that are not due:
//! no single fraction shows it, and all of many answers do.

use super::fractions::{FINE, between, weighed};
use crate::Verdict;
use crate::together::Bounds;
use glam::{Vec2, Vec3, vec3};
use raybook_workbook::exercises::ch16_soft_shadows::{Ball, VisibleFraction};
use std::ops::Range;

/// What may be slightly wrong: with the places on the light, in the order of [`fractions_and_leanings`]; and with the fractions, that they are some share too
/// large, or that some share of what is hidden is taken for seen.
const LEANINGS: [&str; 7] = [
    "the far side of the light along a were chosen too",
    "the far side of the light along b were chosen too",
    "the borders of the light along a were chosen too",
    "the borders of the light along b were chosen too",
    "the ends of a diagonal of the light were chosen too",
    "a sample that is seen were counted too",
    "a sample that is hidden were counted too",
];

/// What is slightly wrong shifts each fraction a little, in a direction that is known: the sum of all fractions' shares in that direction is
/// normally distributed (the score test, Rao 1948). Each of the seven is beyond its bound by chance with 4e-10.
///
/// # Errors
/// What the fractions lean to most, if that is beyond its bound.
pub(super) fn together(answers: &[(VisibleFraction, Vec<f32>)], bounds: Bounds) -> Verdict {
    const DEVIATIONS: f64 = 6.25;
    /// The standard deviation of what the lattice that stands for the exact value is off.
    const LATTICE: f64 = 0.004;
    /// Nearer to 0 and 1 the fractions are not distributed normally.
    const BETWEEN: Range<f64> = 0.02..0.98;
    if !are_independent(answers) {
        return Ok(());
    }
    let (mut sums, mut variances) = ([0.0; LEANINGS.len()], [0.0; LEANINGS.len()]);
    for (q, got) in answers.iter().filter(|(q, _)| q.samples > AGAIN) {
        for (point, got) in fractions_and_leanings(q).into_iter().zip(got) {
            let [f, leanings @ ..] = point.map(f64::from);
            if !BETWEEN.contains(&f) {
                continue;
            }
            let variance = f * (1.0 - f) / f64::from(q.samples) + LATTICE * LATTICE;
            let directions = leanings.into_iter().chain([f, 1.0 - f]);
            for (i, direction) in directions.enumerate() {
                sums[i] += direction * (f64::from(*got) - f) / variance;
                variances[i] += direction * direction / variance;
            }
        }
    }
    let deviations = |i: usize| sums[i] / f64::max(variances[i], f64::MIN_POSITIVE).sqrt();
    let most = (0..LEANINGS.len()).max_by(|&i, &j| {
        let [i, j] = [i, j].map(|i| deviations(i).abs());
        i.total_cmp(&j)
    });
    let Some(i) = most.filter(|&i| deviations(i).abs() > bounds.of(DEVIATIONS)) else {
        return Ok(());
    };
    let (what, by) = (LEANINGS[i], deviations(i));
    let how = if by > 0.0 { "often" } else { "seldom" };
    let by = by.abs();
    Err(format!(
        "the fractions are as if {what} {how}: by {by:.1} standard deviations, which chance does not explain"
    ))
}

/// For each point the fraction, and by how much it is larger where places on the light are chosen a little more often: on one side along a or b, at
/// both borders along a or b, at the ends of a diagonal.
fn fractions_and_leanings(q: &VisibleFraction) -> Vec<[f32; 6]> {
    weighed(q, FINE, between([0.0, 1.0]), |u| {
        let Vec2 { x, y } = u - 0.5;
        let weights = [1.0, x, y, x * x - 1.0 / 12.0, y * y - 1.0 / 12.0, x * y];
        (u, weights)
    })
}

/// Samples of the question that is asked again and again, to see whether each fraction has random numbers of its own.
const AGAIN: u32 = 250;

/// How often it is asked.
const TIMES: usize = 8;

/// That question, whose points are one point.
pub(super) fn again() -> Vec<VisibleFraction> {
    let question = VisibleFraction {
        corner: vec3(-1.0, 4.0, -1.0),
        a: 2.0 * Vec3::X,
        b: 2.0 * Vec3::Z,
        points: vec![Vec3::ZERO; 4],
        balls: vec![Ball {
            center: 2.0 * Vec3::Y,
            radius: 0.35,
        }],
        samples: AGAIN,
    };
    vec![question; TIMES]
}

/// Whether no two answers to that question are alike, nor the fractions of its points. Who takes the same places on the light each time is off to
/// the same side each time, and rightly so.
fn are_independent(answers: &[(VisibleFraction, Vec<f32>)]) -> bool {
    let again = answers.iter().filter(|(q, _)| q.samples == AGAIN);
    let again: Vec<_> = again.map(|(_, got)| got).collect();
    let is_new = |i: usize| !again[..i].contains(&again[i]);
    let is_shared = |got: &&Vec<f32>| got.windows(2).all(|two| two[0] == two[1]);
    again.len() >= TIMES && (0..again.len()).all(is_new) && !again.iter().any(is_shared)
}
