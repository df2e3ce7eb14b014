//! Which pixels of a noisy picture look alike: the weights of non-local means.

use crate::image::Image;
use crate::math::pcg::mix;
use crate::vectors::{Loops, widest};
use std::ops::Range;

/// How far around a pixel similar pixels are looked for, in pixels, in each direction.
pub(super) const WINDOW: isize = 12;

/// Up to this distance all pixels are compared, in pixels, in each direction; beyond it one of [`FEW`], by chance: noise that is as
/// wide as the window is averaged away too, and a wide window takes no more time.
const NEAR: isize = 6;

/// One of this number of pixels that are not near is compared.
const FEW: u64 = 8;

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

/// Maximum d²: a pixel that differs more is left out, for its weight would be below 10⁻³.
const MOST: f32 = 6.9;

/// Rows of a band: the weights of one band at a time are in memory. With more rows, those of a step would be taken from the system, and given
/// back, for each step.
pub(super) const ROWS: usize = 12;

/// A pixel's number, row by row, and its weight.
pub(super) type Weighted = (u32, f32);

/// How much the pixels of a picture look alike: the weights w(p, q) of [`denoise`](super::denoise).
pub(crate) struct Alike {
    width: usize,
    height: usize,
    /// The channels of the picture, one after the other: so several pixels can be compared at once.
    picture: [Vec<f32>; 3],
    /// Those of its variance.
    variance: [Vec<f32>; 3],
}

impl Alike {
    /// For a picture and the variance of its pixels.
    pub(crate) fn new(picture: &Image, variance: &Image) -> Self {
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
        let steps = steps.filter(is_compared);
        let steps = steps.map(|by| widest(Compare(self, by, &rows))).collect();
        let width = self.width;
        Band { width, rows, steps }
    }

    /// All pixels of these rows with those that are a step away.
    #[inline(always)]
    fn step(&self, by: [isize; 2], rows: &Range<usize>) -> Step {
        let Self { width, height, .. } = *self;
        let inside = [(by[0], width), (by[1], height)].map(|(by, n)| inside(by, n));
        let [columns, inside_rows] = &inside;
        let rows = rows.start.max(inside_rows.start)..rows.end.min(inside_rows.end);
        let patches = rows.clone().map(|y| patch(y, inside_rows));
        let all = patches.clone().reduce(|all, last| all.start..last.end);
        let all = all.unwrap_or_default();
        let mut distances = vec![0.0; all.len() * columns.len()];
        for (y, row) in all
            .clone()
            .zip(distances.chunks_exact_mut(columns.len().max(1)))
        {
            self.distances(by, y, columns, row);
        }
        let row = |y: usize| &distances[(y - all.start) * columns.len()..][..columns.len()];
        let mut sums = Vec::with_capacity(rows.len() * columns.len());
        for mut patch in patches {
            let from = sums.len();
            sums.extend_from_slice(patch.next().map_or(&[], row));
            for y in patch {
                let sums = sums[from..].iter_mut();
                sums.zip(row(y))
                    .for_each(|(sum, distance)| *sum += distance);
            }
        }
        Step {
            by,
            inside,
            rows,
            sums,
        }
    }

    /// Writes how much more the pixels of row y, in these columns, differ than by noise from those that are a step away: the mean of
    /// three channels.
    #[inline(always)]
    fn distances(
        &self,
        [dx, dy]: [isize; 2],
        y: usize,
        columns: &Range<usize>,
        distances: &mut [f32],
    ) {
        let (p, n) = (y * self.width + columns.start, columns.len());
        let q = p.wrapping_add_signed(dy * self.width as isize + dx);
        // Slices of one length: so the compiler compares several pixels at once.
        let channel = |i: usize| {
            let [picture, variance] = [&self.picture[i], &self.variance[i]];
            let [p, q] = [p, q].map(|first| [&picture[first..][..n], &variance[first..][..n]]);
            move |x: usize| distance(p.map(|of| of[x]), q.map(|of| of[x]))
        };
        let (r, g, b) = (channel(0), channel(1), channel(2));
        for (x, distance) in distances[..n].iter_mut().enumerate() {
            *distance = (r(x) + g(x) + b(x)) * (1.0 / 3.0);
        }
    }
}

/// Compares all pixels of some rows with those that are a step away.
pub(crate) struct Compare<'a>(
    pub(crate) &'a Alike,
    pub(crate) [isize; 2],
    pub(crate) &'a Range<usize>,
);

impl Loops for Compare<'_> {
    type Answer = Step;

    #[inline(always)]
    fn run(self) -> Step {
        let Self(alike, by, rows) = self;
        alike.step(by, rows)
    }
}

/// How much more two numbers differ than by noise; each with its variance.
#[inline(always)]
fn distance([p, of_p]: [f32; 2], [q, of_q]: [f32; 2]) -> f32 {
    let noise = of_p + least(of_p, of_q);
    let scale = UNSEEN + STRENGTH * (of_p + least(of_q, NOISIER * of_p));
    ((p - q).powi(2) - noise) / scale
}

/// Whether pixels that are this step away are compared. The steps beyond [`NEAR`] follow no rule: those of a lattice would be seen
/// as stripes.
fn is_compared([dx, dy]: &[isize; 2]) -> bool {
    let number = (dy * (2 * WINDOW + 1) + dx) as u64;
    dx.abs().max(dy.abs()) <= NEAR || mix(number).is_multiple_of(FEW)
}

/// The lesser of two numbers: one instruction, where `min` also asks for NaN.
#[inline(always)]
fn least(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

/// Some rows of a picture.
pub(super) struct Band {
    width: usize,
    pub(super) rows: Range<usize>,
    /// From each of their pixels to all pixels of its window.
    steps: Vec<Step>,
}

impl Band {
    /// The pixels that look like p, for each of these pixels p of row y of the band; p itself is among them.
    ///
    /// All pixels are asked of one step before the next: the numbers of a step lie side by side in memory.
    pub(super) fn row(&self, columns: &[usize], y: usize) -> Vec<([usize; 2], Vec<Weighted>)> {
        let empty = |x: &usize| ([*x, y], Vec::with_capacity(self.steps.len()));
        let mut all: Vec<_> = columns.iter().map(empty).collect();
        for step in &self.steps {
            let Some(row) = step.row(y) else {
                continue;
            };
            let q =
                (y * self.width).wrapping_add_signed(step.by[1] * self.width as isize + step.by[0]);
            for ([x, _], around) in &mut all {
                if let Some(weight) = row.weight(*x) {
                    around.push((q.wrapping_add(*x) as u32, weight));
                }
            }
        }
        all
    }
}

/// Pixels p, each with the pixel q that is a step away.
pub(crate) struct Step {
    /// Columns and rows from p to q.
    by: [isize; 2],
    /// The columns and the rows of the picture from which the step leads to a pixel.
    inside: [Range<usize>; 2],
    /// The rows of p.
    rows: Range<usize>,
    /// For each p, the sum over the rows of its patch of what d² is the mean of.
    pub(crate) sums: Vec<f32>,
}

impl Step {
    /// The p of row y, unless no q of theirs is in the picture.
    fn row(&self, y: usize) -> Option<Row<'_>> {
        let [columns, rows] = &self.inside;
        self.rows.contains(&y).then(|| Row {
            columns,
            sums: &self.sums[(y - self.rows.start) * columns.len()..][..columns.len()],
            down: patch(y, rows).len(),
        })
    }
}

/// The p of a row of a step.
struct Row<'a> {
    /// The columns from which the step leads to a pixel.
    columns: &'a Range<usize>,
    /// The step's sums of these columns.
    sums: &'a [f32],
    /// The number of rows of a patch.
    down: usize,
}

impl Row<'_> {
    /// The weight of the q of the p in column x, unless it is outside the picture, or the weight is too small to count.
    fn weight(&self, x: usize) -> Option<f32> {
        if !self.columns.contains(&x) {
            return None;
        }
        let across = patch(x, self.columns);
        let row = &self.sums[across.start - self.columns.start..][..across.len()];
        // Most patches are whole: a loop of a fixed number of rounds is none.
        let whole: Result<&[f32; 2 * PATCH + 1], _> = row.try_into();
        let sum: f32 = whole.map_or_else(|_| row.iter().sum(), |whole| whole.iter().sum());
        let squared = (sum / (across.len() * self.down) as f32).max(0.0);
        (squared < MOST).then(|| (-squared).exp())
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
