//! By how much fractions are off if strips at the edges of the light are left out, as by a random number that is multiplied by 0.95.

use super::{BETWEEN, Point};
use crate::cases::ch16_soft_shadows::visible_fraction::fractions::{FINE, seen};
use raybook_workbook::exercises::ch16_soft_shadows::VisibleFraction;

/// Width of a strip that may be left out, as a share of the light's side. What wider and narrower strips make of a fraction is nearly in proportion.
const WIDTH: f64 = 0.05;

/// From where to where along a side places are chosen: all the way, not at its end, not at its beginning, or at neither.
const ALL: [f64; 2] = [0.0, 1.0];
const NO_END: [f64; 2] = [0.0, 1.0 - WIDTH];
const NO_BEGINNING: [f64; 2] = [WIDTH, 1.0];
const NEITHER: [f64; 2] = [0.5 * WIDTH, 1.0 - 0.5 * WIDTH];

/// What may be left out: from where to where places are chosen along a and along b, and the strips in words.
const STRIPS: [([[f64; 2]; 2], &str); 11] = [
    ([NO_END, ALL], "a strip at the end of a"),
    ([NO_BEGINNING, ALL], "a strip at the beginning of a"),
    ([NEITHER, ALL], "strips at both ends of a"),
    ([ALL, NO_END], "a strip at the end of b"),
    ([ALL, NO_BEGINNING], "a strip at the beginning of b"),
    ([ALL, NEITHER], "strips at both ends of b"),
    ([NO_END, NO_END], "strips at the ends of a and b"),
    (
        [NO_BEGINNING, NO_BEGINNING],
        "strips at the beginnings of a and b",
    ),
    (
        [NO_END, NO_BEGINNING],
        "strips at the end of a and at the beginning of b",
    ),
    (
        [NO_BEGINNING, NO_END],
        "strips at the beginning of a and at the end of b",
    ),
    ([NEITHER, NEITHER], "a border on all four sides"),
];

/// How much each of the places along a side of the lattice counts, if places are chosen between these ends: a cell of the lattice as far as it is there.
fn shares([from, to]: [f64; 2]) -> Vec<f64> {
    let count = f64::from(FINE);
    let inside = |i: u32| to.min(f64::from(i + 1) / count) - from.max(f64::from(i) / count);
    (0..FINE)
        .map(|i| inside(i).max(0.0) * count / (to - from))
        .collect()
}

/// How much the fractions of a question tell of a border that is left out on all four sides, about: Σ b²/σ², by a coarse lattice.
pub(super) fn told(q: &VisibleFraction) -> f64 {
    const COARSE: u32 = 8;
    let all = seen(q, COARSE, |u| u);
    let inner = seen(q, COARSE, |u| 0.5 + 0.8 * (u - 0.5));
    let by = |(all, inner): (f32, f32)| {
        let [f, b] = [all, inner - all].map(f64::from);
        if BETWEEN.contains(&f) {
            b * b / (f * (1.0 - f))
        } else {
            0.0
        }
    };
    all.into_iter().zip(inner).map(by).sum()
}

/// What strips are left out, and by how much each of the fractions is larger then.
pub(super) fn biases(points: &[Point]) -> Vec<(&'static str, Vec<f64>)> {
    let mut all: Vec<_> = STRIPS.iter().map(|(_, what)| (*what, Vec::new())).collect();
    let shares_of = [ALL, NO_END, NO_BEGINNING, NEITHER].map(|ends| (ends, shares(ends)));
    let of = |ends: [f64; 2]| {
        let mut known = shares_of.iter().enumerate();
        known
            .find(|(_, (of, _))| *of == ends)
            .expect("one of the four")
    };
    for point in points {
        // Of each row of places, how much of it is seen.
        let row = |row: &[bool], shares: &[f64]| {
            let seen = row.iter().zip(shares).filter(|(seen, _)| **seen);
            seen.map(|(_, share)| share).sum::<f64>()
        };
        let rows = |shares: &[f64]| {
            let all = point.seen.chunks(FINE as usize);
            all.map(|seen| row(seen, shares)).collect::<Vec<_>>()
        };
        let rows = shares_of.each_ref().map(|(_, shares)| rows(shares));
        for ((along, _), (_, biases)) in STRIPS.iter().zip(&mut all) {
            let [(a, _), (_, (_, along_b))] = along.map(of);
            let sum: f64 = rows[a]
                .iter()
                .zip(along_b)
                .map(|(row, share)| row * share)
                .sum();
            biases.push(sum / point.seen.len() as f64 - point.fraction);
        }
    }
    all
}
