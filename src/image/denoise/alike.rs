//! Which pixels of a noisy picture look alike: the weights of non-local means.

use crate::image::Image;
use std::ops::Range;

/// How far around a pixel similar pixels are looked for, in pixels, in each direction.
pub(super) const WINDOW: isize = 7;

/// How far around a pixel its patch reaches, in pixels, in each direction. Two pixels are compared by their patches.
const PATCH: usize = 2;

/// k²: the squared difference of two pixels, beyond what noise explains, at which the weight is 1/e; in units of the variance of
/// their difference.
const STRENGTH: f32 = 0.5;

/// The variance of a pixel q counts as at most `NOISIER` times the variance of p. Without this limit, a pixel with a single
/// bright path, which makes both the pixel and its variance large, would be similar to everything around it.
const NOISIER: f32 = 8.0;

/// A squared difference of radiance that is too small to be seen; it keeps the denominator above 0.
const UNSEEN: f32 = 1e-6;

/// A smaller weight is left out.
const LEAST: f32 = 1e-3;

/// Rows of a band: the weights of one band at a time are in memory.
pub(super) const ROWS: usize = 24;

/// A pixel's place, column and row, and its weight.
pub(super) type Weighted = ([usize; 2], f32);

/// How much the pixels of a picture look alike: the weights w(p, q) of [`denoise`](super::denoise).
pub(super) struct Alike {
    width: usize,
    height: usize,
    /// The channels of the picture, one after the other: so several pixels can be compared at once.
    picture: [Vec<f32>; 3],
    /// Those of its variance.
    variance: [Vec<f32>; 3],
}

impl Alike {
    /// For a picture and the variance of its pixels.
    pub(super) fn new(picture: &Image, variance: &Image) -> Self {
        let channels = |of: &Image| {
            [0, 1, 2].map(|channel| of.pixels.iter().map(|p| p.channels()[channel]).collect())
        };
        Self {
            width: picture.width,
            height: picture.height,
            picture: channels(picture),
            variance: channels(variance),
        }
    }

    /// The band of [`ROWS`] rows, or what is left of them, from `top` on.
    pub(super) fn band(&self, top: usize) -> Band {
        let along = || -WINDOW..=WINDOW;
        let rows = top..(top + ROWS).min(self.height);
        let steps = along().flat_map(|dy| along().map(move |dx| [dx, dy]));
        let steps = steps.map(|step| self.step(step, &rows)).collect();
        Band { rows, steps }
    }

    /// All pixels of these rows, and of their patches, with those that are a step away.
    fn step(&self, by: [isize; 2], rows: &Range<usize>) -> Step {
        let Self { width, height, .. } = *self;
        let [columns, inside] = [(by[0], width), (by[1], height)].map(|(by, n)| inside(by, n));
        let first = patch(rows.start, &inside).start;
        let rows = first..patch(rows.end - 1, &inside).end.max(first);
        let distances = rows
            .clone()
            .map(|y| self.distances(by, y, &columns))
            .collect();
        Step {
            by,
            columns,
            rows,
            distances,
        }
    }

    /// How much more the pixels of a row differ than by noise from those that are a step away: the mean of three channels.
    fn distances<'a>(&'a self, [dx, dy]: [isize; 2], y: usize, columns: &Range<usize>) -> Vec<f32> {
        let p = y * self.width + columns.start;
        let q = p.wrapping_add_signed(dy * self.width as isize + dx);
        let mut sums = vec![0.0; columns.len()];
        for (picture, variance) in self.picture.iter().zip(&self.variance) {
            let row = |of: &'a Vec<f32>, first: usize| of[first..][..columns.len()].iter();
            let pairs = row(picture, p).zip(row(picture, q));
            let variances = row(variance, p).zip(row(variance, q));
            for (sum, ((p, q), (of_p, of_q))) in sums.iter_mut().zip(pairs.zip(variances)) {
                let noise = of_p + least(*of_p, *of_q);
                let scale = UNSEEN + STRENGTH * (of_p + least(*of_q, NOISIER * of_p));
                *sum += ((p - q).powi(2) - noise) / scale * (1.0 / 3.0);
            }
        }
        sums
    }
}

/// The lesser of two numbers: one instruction, where `min` also asks for NaN.
fn least(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

/// Some rows of a picture.
pub(super) struct Band {
    pub(super) rows: Range<usize>,
    /// From each of their pixels to all pixels of its window.
    steps: Vec<Step>,
}

impl Band {
    /// The pixels that look like p, which is in the band; p itself is among them.
    pub(super) fn around(&self, p: [usize; 2]) -> impl Iterator<Item = Weighted> {
        self.steps.iter().filter_map(move |step| step.weighted(p))
    }
}

/// Pixels p, each with the pixel q that is a step away.
struct Step {
    /// Columns and rows from p to q.
    by: [isize; 2],
    /// The columns and the rows of p.
    columns: Range<usize>,
    rows: Range<usize>,
    /// What d² is the mean of, row by row.
    distances: Vec<Vec<f32>>,
}

impl Step {
    /// The q of this p and its weight, unless it is outside the picture, or the weight is too small to count.
    fn weighted(&self, [x, y]: [usize; 2]) -> Option<Weighted> {
        if !self.columns.contains(&x) || !self.rows.contains(&y) {
            return None;
        }
        let (across, down) = (patch(x, &self.columns), patch(y, &self.rows));
        let (left, count) = (across.start - self.columns.start, across.len() * down.len());
        let row = |y: usize| &self.distances[y - self.rows.start][left..][..across.len()];
        let sum: f32 = down.map(|y| row(y).iter().sum::<f32>()).sum();
        let weight = (-(sum / count as f32).max(0.0)).exp();
        let q = [
            x.wrapping_add_signed(self.by[0]),
            y.wrapping_add_signed(self.by[1]),
        ];
        (weight > LEAST).then_some((q, weight))
    }
}

/// The places on an axis of n pixels from which the step leads to a place on it.
fn inside(step: isize, n: usize) -> Range<usize> {
    let [before, after] = [-step, step].map(|out| out.max(0) as usize);
    before..n.saturating_sub(after).max(before)
}

/// The places around i along an axis that belong to its patch.
fn patch(i: usize, inside: &Range<usize>) -> Range<usize> {
    let end = (i + PATCH + 1).min(inside.end);
    i.saturating_sub(PATCH)
        .clamp(inside.start, end.max(inside.start))..end.max(inside.start)
}
