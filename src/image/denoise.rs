//! Denoising a picture of random samples: each pixel becomes a mean of the pixels around it that differ from it by noise only.

use crate::image::{Image, rgb::Rgb};
use crate::threads;
use std::ops::Range;

/// How far around a pixel similar pixels are looked for, in pixels, in each direction.
const WINDOW: isize = 5;

/// How far around a pixel its patch reaches, in pixels, in each direction. Two pixels are compared by their patches.
const PATCH: usize = 2;

/// k²: the squared difference of two pixels, beyond what noise explains, at which the weight is 1/e; in units of the variance of
/// their difference.
const STRENGTH: f32 = 0.2;

/// The variance of a pixel q counts as at most `NOISIER` times the variance of p. Without this limit, a pixel with a single
/// bright path, which makes both the pixel and its variance large, would be similar to everything around it.
const NOISIER: f32 = 8.0;

/// A squared difference of radiance that is too small to be seen; it keeps the denominator above 0.
const UNSEEN: f32 = 1e-6;

/// Maximum brightness of a pixel, in units of the brightest pixel that the other picture has around it. A brighter pixel comes
/// from a very rare path.
const BRIGHTEST: f32 = 2.0;

// ANCHOR: denoise
/// The mean of two pictures of the same view, made with different random numbers, with less noise and sharp edges.
///
/// Non-local means (Rousselle, Knaus and Zwicker, "Adaptive rendering with non-local means filtering", 2012): a pixel p becomes
/// Σ w(p, q)·q/Σ w(p, q) over the pixels q around p, with w = exp(−max(0, d²)), where d² is the mean over the patches around
/// p and q of ((p − q)² − (V(p) + min(V(p), V(q))))/(ε + k²·(V(p) + min(V(q), 8 V(p)))), with k² = 0.2 and ε = 10⁻⁶. V is the
/// variance of a pixel, estimated from the difference of the two pictures. Each picture is averaged with the weights of the other
/// one, so that noise does not choose its own weights.
///
/// The result is biased: a little too dark where a few rare paths bring much light. A pixel that is bright in only one of the
/// pictures counts no more than twice the brightest pixel around it in the other.
///
/// # Panics
/// If the pictures differ in size.
pub fn denoise(pictures: &[Image; 2]) -> Image {
    let [a, b] = pictures;
    let size = |picture: &Image| (picture.width, picture.height);
    assert_eq!(size(a), size(b), "both pictures have one size");
    let halves = [clamped(a, b), clamped(b, a)];
    let [a, b] = &halves;
    let variance = variance(a, b);
    let (a, b) = threads::join(|| averaged(a, b, &variance), || averaged(b, a, &variance));
    let pixels = a.into_iter().zip(b).map(|(a, b)| (a + b) * 0.5);
    Image {
        pixels: pixels.collect(),
        ..halves[0]
    }
}

/// The pixels of `picture`, each averaged with the pixels around it, with the weights of `other`.
fn averaged(picture: &Image, other: &Image, variance: &Image) -> Vec<Rgb> {
    let mut sums = vec![(Rgb::BLACK, 0.0); picture.pixels.len()];
    for step in around(WINDOW) {
        let Some(pairs) = Pairs::new(picture, step) else {
            continue; // the picture is smaller than this step
        };
        let distances = pairs.patches(&pairs.distances(other, variance));
        let mut distances = distances.into_iter();
        for (p, q) in pairs.rows() {
            for ((sum, weights), q) in sums[p].iter_mut().zip(&picture.pixels[q]) {
                let weight = distances.next().map_or(0.0, |d| (-d.max(0.0)).exp());
                *sum += *q * weight;
                *weights += weight;
            }
        }
    }
    sums.into_iter()
        .map(|(sum, weights)| sum / weights)
        .collect()
}
// ANCHOR_END: denoise

/// The pixels p of a picture that have a pixel q a step away: a rectangle, row by row.
struct Pairs {
    /// The indices of the first p and of the first q.
    first: [usize; 2],
    /// Width and height of the rectangle, in pixels.
    size: [usize; 2],
    /// Width of the picture, in pixels.
    stride: usize,
}

impl Pairs {
    /// `None` if no pixel has another pixel at this step.
    fn new(picture: &Image, (dx, dy): (isize, isize)) -> Option<Self> {
        let along = |step: isize, size: usize| {
            let left = size.checked_sub(step.unsigned_abs())?;
            let [p, q] = [-step, step].map(|before| before.max(0) as usize);
            (left > 0).then_some((p, q, left))
        };
        let (px, qx, width) = along(dx, picture.width)?;
        let (py, qy, height) = along(dy, picture.height)?;
        let stride = picture.width;
        Some(Self {
            first: [py * stride + px, qy * stride + qx],
            size: [width, height],
            stride,
        })
    }

    /// The indices of the pixels p of each row, and of their q.
    fn rows(&self) -> impl Iterator<Item = (Range<usize>, Range<usize>)> {
        let ([p, q], [width, height]) = (self.first, self.size);
        let row = move |first: usize| first..first + width;
        (0..height).map(move |y| (row(p + y * self.stride), row(q + y * self.stride)))
    }

    /// d² of each p and its q, before the mean over the patches: how much more they differ than by noise.
    fn distances(&self, picture: &Image, variance: &Image) -> Vec<f32> {
        let noise = |p: f32, q: f32, of_p: f32, of_q: f32| {
            ((p - q).powi(2) - (of_p + of_p.min(of_q)))
                / (UNSEEN + STRENGTH * (of_p + of_q.min(NOISIER * of_p)))
        };
        let mut distances = Vec::with_capacity(self.size[0] * self.size[1]);
        for (p, q) in self.rows() {
            let [of_p, of_q] = [&p, &q].map(|row| &variance.pixels[row.clone()]);
            let pixels = picture.pixels[p].iter().zip(&picture.pixels[q]);
            let pairs = pixels.zip(of_p.iter().zip(of_q));
            distances.extend(pairs.map(|((p, q), (of_p, of_q))| {
                let channels = noise(p.r, q.r, of_p.r, of_q.r)
                    + noise(p.g, q.g, of_p.g, of_q.g)
                    + noise(p.b, q.b, of_p.b, of_q.b);
                channels / 3.0
            }));
        }
        distances
    }

    /// The mean of each patch: first of the neighbours in a row, then of the neighbours in a column.
    fn patches(&self, values: &[f32]) -> Vec<f32> {
        let [width, height] = self.size;
        let near = |i: usize, n: usize| i.saturating_sub(PATCH)..(i + PATCH + 1).min(n);
        let mut means = Vec::with_capacity(values.len());
        for row in values.chunks_exact(width) {
            means.extend((0..width).map(|x| {
                let near = &row[near(x, width)];
                near.iter().sum::<f32>() / near.len() as f32
            }));
        }
        let mut patches = vec![0.0; values.len()];
        for (y, patches) in patches.chunks_exact_mut(width).enumerate() {
            let rows = near(y, height);
            let share = 1.0 / rows.len() as f32;
            for row in rows {
                for (sum, mean) in patches.iter_mut().zip(&means[row * width..]) {
                    *sum += share * mean;
                }
            }
        }
        patches
    }
}

/// The variance of each pixel in one picture: half the squared difference of the two pictures, averaged over 3 × 3 pixels.
fn variance(a: &Image, b: &Image) -> Image {
    let squares = a.pixels.iter().zip(&b.pixels);
    let pixels = squares.map(|(a, b)| {
        let difference = *a + *b * -1.0;
        difference * difference * 0.5
    });
    let noisy = Image {
        pixels: pixels.collect(),
        ..*a
    };
    neighbours(&noisy, |around| {
        let (sum, count) = around.fold((Rgb::BLACK, 0.0), |(sum, n), v| (sum + v, n + 1.0));
        sum / count
    })
}

/// The picture, with each channel at most [`BRIGHTEST`] times the brightest that `other` has in the 3 × 3 pixels around.
fn clamped(picture: &Image, other: &Image) -> Image {
    let most = neighbours(other, |around| {
        let brighter = |a: Rgb, b: Rgb| Rgb::new(a.r.max(b.r), a.g.max(b.g), a.b.max(b.b));
        around.fold(Rgb::BLACK, brighter) * BRIGHTEST
    });
    let pairs = picture.pixels.iter().zip(&most.pixels);
    let pixels = pairs.map(|(p, most)| Rgb::new(p.r.min(most.r), p.g.min(most.g), p.b.min(most.b)));
    Image {
        pixels: pixels.collect(),
        ..*picture
    }
}

/// The picture whose pixels are f of each pixel and the eight around it.
fn neighbours(picture: &Image, f: impl Fn(&mut dyn Iterator<Item = Rgb>) -> Rgb) -> Image {
    let near = |i: usize, n: usize| i.saturating_sub(1)..(i + 2).min(n);
    Image::from_fn(picture.width, picture.height, |x, y| {
        let columns = near(x, picture.width);
        let rows = near(y, picture.height);
        f(&mut rows.flat_map(|y| columns.clone().map(move |x| picture.at(x, y))))
    })
}

/// The steps to all pixels that are at most `reach` away along each axis.
fn around(reach: isize) -> impl Iterator<Item = (isize, isize)> {
    (-reach..=reach).flat_map(move |dy| (-reach..=reach).map(move |dx| (dx, dy)))
}

#[cfg(test)]
mod tests {
    use super::denoise;
    use crate::image::{Image, rgb::Rgb};
    use crate::math::pcg;
    use rand::RngExt;

    /// A step from dark to bright in the middle, with noise of a tenth.
    fn step(seed: u64) -> Image {
        let mut rng = pcg::stream(seed, 3);
        Image::from_fn(48, 24, |x, _| {
            let radiance = if x < 24 { 0.2 } else { 1.0 };
            Rgb::gray(radiance * rng.random_range(0.7..1.3))
        })
    }

    #[test]
    fn noise_falls_and_the_edge_stays() {
        let pictures = [step(1), step(2)];
        let clean = denoise(&pictures);
        let error = |picture: &Image, x: usize, true_value: f32| {
            let off = |y| (picture.at(x, y).g / true_value - 1.0).powi(2);
            (0..24).map(off).sum::<f32>() / 24.0
        };
        for (x, value) in [(12, 0.2), (36, 1.0), (23, 0.2), (24, 1.0)] {
            let before = 0.5 * error(&pictures[0], x, value);
            let after = error(&clean, x, value);
            assert!(after < 0.25 * before, "column {x}: {before} and {after}");
        }
        let mean = |from: usize| {
            let row = |y| (from..from + 24).map(|x| clean.at(x, y).g).sum::<f32>();
            (0..24).map(row).sum::<f32>() / 576.0
        };
        assert!((mean(0) / 0.2 - 1.0).abs() < 0.02 && (mean(24) - 1.0).abs() < 0.02);
    }

    #[test]
    fn a_pixel_that_only_one_picture_has_is_no_pixel_of_the_view() {
        let mut pictures = [step(1), step(2)];
        pictures[0].set(40, 10, Rgb::gray(500.0));
        let clean = denoise(&pictures);
        for (x, y) in [(40, 10), (41, 10), (38, 12)] {
            assert!(clean.at(x, y).g < 1.2, "{}", clean.at(x, y).g);
        }
    }
}
