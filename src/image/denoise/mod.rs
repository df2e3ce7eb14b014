//! Denoising a picture of random samples: the colours around each pixel that differ by noise only are replaced by a plane fitted
//! to them.
//!
//! ```
//! use raybook::image::denoise::denoise;
//! use raybook::image::rms::rms;
//! use raybook::prelude::*;
//!
//! // A grey wall, drawn twice with noise of ± 0.1.
//! let noisy = |odd: usize| Image::from_fn(16, 16, |x, y| Rgb::gray([0.4, 0.6][(x * 7 + y * 5 + x * y + odd) % 2]));
//! let smooth = denoise(&[noisy(0), noisy(1)], &[]);
//! let wall = Image::from_fn(16, 16, |_, _| Rgb::gray(0.5));
//! assert!(rms(&wall, &smooth, |_, _| true) < 0.2 * rms(&wall, &noisy(0), |_, _| true));
//! ```

#![expect(
    clippy::inline_always,
    reason = "a function called from AVX2 code is compiled with it only where it is inlined"
)]

pub(crate) mod alike;
pub(crate) mod fit;

use crate::image::{Image, around, rgb::Rgb};
use crate::threads;
use crate::vectors::{Loops, widest};
use alike::{Alike, ROWS, Weighted};
use fit::{Fit, GUIDED, PLACE, Terms};
use glam::Vec3;
use std::ops::{AddAssign, Div};

/// Between two pixels around which a plane is fitted, in pixels, along each axis.
const APART: usize = 4;

/// A plane is also fitted around a pixel for which the weights of the planes before it have a smaller sum: it looks like few others.
const ENOUGH: f32 = 1.0;

/// Number of pixels for which weights are computed together: so few that the weights stay in a processor's cache.
const TOGETHER: usize = 32;

/// Maximum brightness of a pixel, in units of the brightest pixel that the other picture has around it. A brighter pixel comes
/// from a very rare path.
const BRIGHTEST: f32 = 2.0;

/// What is known of a pixel without noise: means over what is seen in the pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Guide {
    /// The surface's colour: the share of the light that it reflects, or the radiance where no surface is seen.
    pub colour: Rgb,
    /// The surface's normal; 0 where no surface is seen.
    pub normal: Vec3,
    /// 1 over the distance of the surface, in 1/m: on a plane it is a first-order function of the place in the picture.
    pub nearness: f32,
}

impl AddAssign for Guide {
    fn add_assign(&mut self, other: Self) {
        self.colour += other.colour;
        self.normal += other.normal;
        self.nearness += other.nearness;
    }
}

impl Div<f32> for Guide {
    type Output = Self;

    fn div(self, divisor: f32) -> Self {
        Self {
            colour: self.colour / divisor,
            normal: self.normal / divisor,
            nearness: self.nearness / divisor,
        }
    }
}

// ANCHOR: denoise
/// The mean of two pictures of the same view, made with different random numbers, with less noise and sharp edges.
///
/// Around every fourth pixel p of every fourth row, a plane is fitted to the pixels q that look as p does: their colour as a
/// first-order function of their place and, where there are `guides`, of these. It is fitted by least squares, with weights
/// w(p, q). Then a pixel becomes the mean of all planes around it, with the same weights (Bitterli et al., "Nonlinearly weighted
/// first-order regression for denoising Monte Carlo renderings", 2016). So what the guides know stays sharp, as edges and
/// textures, and what they do not know, as the edge of a shadow, stays where w tells it from noise.
///
/// w = exp(−max(0, d²)), where d² is the mean over the patches around p and q of
/// ((p − q)² − (V(p) + min(V(p), V(q))))/(ε + k²·(V(p) + min(V(q), 8 V(p)))), with k² = 0.5 and ε = 10⁻⁶ (non-local means:
/// Rousselle, Knaus and Zwicker, "Adaptive rendering with non-local means filtering", 2012). V is the variance of a pixel,
/// estimated from the difference of the two pictures; p, q and V are of ln(1 + colour), so that a highlight, whose noise is larger
/// than all that is around it, does not look like it. Each picture is fitted with the weights of the other one, so that noise does
/// not choose its own weights.
///
/// The result is biased: a little too dark where a few rare paths bring much light. A pixel that is bright in only one of the
/// pictures counts no more than twice the brightest pixel around it in the other.
///
/// # Panics
/// If the pictures differ in size, or if there are guides, but not one per pixel, row by row.
pub fn denoise(pictures: &[Image; 2], guides: &[Guide]) -> Image {
    denoise_while(pictures, guides, &|| true)
}

/// As [`denoise`], but it ends, without a picture that is of use, as soon as `go_on` returns false.
pub(crate) fn denoise_while(
    pictures: &[Image; 2],
    guides: &[Guide],
    go_on: &(dyn Fn() -> bool + Sync),
) -> Image {
    let [a, b] = pictures;
    let size = |picture: &Image| (picture.width, picture.height);
    assert_eq!(size(a), size(b), "both pictures have one size");
    assert!(
        [0, a.pixels.len()].contains(&guides.len()),
        "one guide per pixel, or none"
    );
    let halves = [clamped(a, b), clamped(b, a)];
    let [a, b] = &halves;
    let [seen_a, seen_b] = [a, b].map(compressed);
    let variance = variance(&seen_a, &seen_b);
    let fitted = if guides.is_empty() {
        fitted::<PLACE>
    } else {
        fitted::<GUIDED>
    };
    let (a, b) = threads::join(
        || fitted(a, guides, &Alike::new(&seen_b, &variance), go_on),
        || fitted(b, guides, &Alike::new(&seen_a, &variance), go_on),
    );
    let pixels = a.into_iter().zip(b).map(|(a, b)| (a + b) * 0.5);
    Image {
        pixels: pixels.collect(),
        ..halves[0]
    }
}

/// The pixels of `picture`, each the mean of the planes around it, by N terms.
fn fitted<const N: usize>(
    picture: &Image,
    guides: &[Guide],
    alike: &Alike,
    go_on: &dyn Fn() -> bool,
) -> Vec<Rgb> {
    let width = picture.width;
    let place = |[x, y]: [usize; 2]| y * width + x;
    let guide = |i: usize| guides.get(i).copied().unwrap_or_default();
    let terms = |i| Terms::<N>::of([i % width, i / width], guide(i));
    let terms: Vec<_> = (0..picture.pixels.len()).map(terms).collect();
    let mut sums = vec![(Rgb::BLACK, 0.0); picture.pixels.len()];
    for top in (0..picture.height).step_by(ROWS).take_while(|_| go_on()) {
        let band = alike.band(top);
        let every = |n: usize| band.rows.clone().step_by(n).map(move |y| (y, n));
        for (y, n) in every(APART).chain(every(1)).take_while(|_| go_on()) {
            let needed = |sums: &[(Rgb, f32)], p| n > 1 || sums[place(p)].1 < ENOUGH;
            let columns: Vec<_> = (0..width).step_by(n).collect();
            for columns in columns.chunks(TOGETHER) {
                let columns = columns.iter().copied();
                let columns = columns.filter(|x| needed(&sums, [*x, y]));
                for (p, around) in band.row(&columns.collect::<Vec<_>>(), y) {
                    // The planes before it may have reached it.
                    if needed(&sums, p) {
                        widest(Spread {
                            pixels: &picture.pixels,
                            terms: &terms,
                            p: place(p),
                            around: &around,
                            sums: &mut sums,
                        });
                    }
                }
            }
        }
    }
    sums.into_iter()
        .map(|(sum, weights)| sum / weights)
        .collect()
}

/// Fits a plane around a pixel, and adds it to the sums of the pixels that look like it.
pub(crate) struct Spread<'a, const N: usize> {
    pub(crate) pixels: &'a [Rgb],
    pub(crate) terms: &'a [Terms<N>],
    pub(crate) p: usize,
    /// The pixels that look like p, with their weights.
    pub(crate) around: &'a [Weighted],
    /// For each pixel, Σ w plane and Σ w.
    pub(crate) sums: &'a mut [(Rgb, f32)],
}

impl<const N: usize> Loops for Spread<'_, N> {
    type Answer = ();

    #[inline(always)]
    fn run(self) {
        let centre = self.terms[self.p];
        let terms = |q: u32| self.terms[q as usize].from(&centre);
        let mut fit = Fit::new();
        for &(q, weight) in self.around {
            fit.add(weight, &terms(q), self.pixels[q as usize]);
        }
        let plane = fit.solve();
        for &(q, weight) in self.around {
            let (sum, weights) = &mut self.sums[q as usize];
            *sum += plane.at(&terms(q)) * weight;
            *weights += weight;
        }
    }
}
// ANCHOR_END: denoise

/// ln(1 + c) of each channel c.
fn compressed(picture: &Image) -> Image {
    picture.map(|p| p.map(f32::ln_1p))
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
    let size = [picture.width, picture.height];
    Image::from_fn(picture.width, picture.height, |x, y| {
        f(&mut around([x, y], 1, size).map(|[x, y]| picture.at(x, y)))
    })
}
