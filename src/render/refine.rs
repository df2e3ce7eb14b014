//! The film loop with fewer samples: few where they are similar, all of them where they differ.
//!
//! ```
//! use raybook::prelude::*;
//! use std::sync::atomic::{AtomicU32, Ordering};
//!
//! // An edge is in the last pixel, so all other pixels but its neighbour get 4 of the 64 samples.
//! let taken = AtomicU32::new(0);
//! let picture = Film::new(32, 1, 64).refine(|place, _| {
//!     taken.fetch_add(1, Ordering::Relaxed);
//!     Rgb::gray(if place.x < 0.98 { 1.0 } else { 0.0 })
//! });
//! assert_eq!(picture.at(0, 0), Rgb::WHITE);
//! assert!(taken.into_inner() < 32 * 64 / 4);
//! ```

use crate::image::{Image, around, rgb::Rgb};
use crate::render::film::{Done, Film};
use crate::render::{followed::Followed, gather::Gathered};
use crate::sample::even::Even;
use arrayvec::ArrayVec;
use glam::Vec2;
use std::sync::atomic::{AtomicBool, Ordering};

/// Number of first samples of every pixel, for `all` samples per pixel: 4, or half of `all` below 8, but at least 2 if there are as many,
/// because one sample has no deviation.
fn first_of(all: usize) -> usize {
    (all / 2).clamp(2, FIRST).min(all)
}

/// Maximum number of first samples.
const FIRST: usize = 4;

/// The standard deviation of the displayed brightness, in [0, 1], from which on a pixel gets all samples.
const RESTLESS: f32 = 0.2;

/// The radiance at a place on the film, by a sample's random numbers.
type Radiance<'a> = dyn Fn(Vec2, &mut Even) -> Followed + Sync + 'a;

/// The result of the first samples of a pixel.
#[derive(Clone, Default)]
struct Begun {
    samples: Gathered,
    /// The mean of the displayed brightness.
    mean: Rgb,
    /// The variance of the displayed brightness, of the channel with the largest variance.
    variance: f32,
}

impl Film<'_> {
    /// The picture whose pixels are the mean of `radiance` over all samples, weighted by the film's filter, with
    /// low-discrepancy numbers ([`Even`]).
    ///
    /// `radiance` gets the place on the film, in [0, 1]² from the top left, and the sample's random numbers.
    pub fn evenly<S: Into<Followed>>(
        &self,
        radiance: impl Fn(Vec2, &mut Even) -> S + Sync,
    ) -> Image {
        all(self, &|place, numbers| radiance(place, numbers).into())
    }

    /// As [`Film::evenly`], but a pixel gets all samples only if its first samples differ much; otherwise its number of samples
    /// is proportional to their standard deviation, rounded up to a power of two, and at least 4, or 2 if the film has fewer than 6
    /// samples per pixel (Whitted 1980; Neyman 1934).
    ///
    /// The standard deviation is that of the pixel and its eight neighbours, because the pixel's first samples may have missed an
    /// edge. Details that all first samples miss are not found. So for light that is found by chance, as in path tracing and
    /// through a lens, use [`Film::evenly`].
    pub fn refine<S: Into<Followed>>(
        &self,
        radiance: impl Fn(Vec2, &mut Even) -> S + Sync,
    ) -> Image {
        refined(self, &|place, numbers| radiance(place, numbers).into())
    }
}

fn all(film: &Film, radiance: &Radiance) -> Image {
    film.expose(&|x, y, _| {
        let seen = |i| seen(film, [x, y], i, radiance);
        Gathered::of(film, (0..film.samples).map(seen))
    })
}

// ANCHOR: refine
fn refined(film: &Film, radiance: &Radiance) -> Image {
    let all = film.samples;
    let first = first_of(all);
    // Half of each pixel is done with its first samples, and half with the rest.
    let is_ended = AtomicBool::new(false);
    let begins = Film {
        progress: &|done| {
            let pixels = done.pixels.div_ceil(2);
            let flow = (film.progress)(Done { pixels, ..done });
            is_ended.fetch_or(flow.is_break(), Ordering::Relaxed);
            flow
        },
        ..*film
    };
    let begun = begins.each_pixel(&|x, y, _| {
        let seen = |i| seen(film, [x, y], i, radiance);
        let seen: ArrayVec<_, FIRST> = (0..first).map(seen).collect();
        Begun::by(film, &seen)
    });
    if is_ended.into_inner() {
        let samples: Vec<_> = begun.into_iter().map(|pixel| pixel.samples).collect();
        return film.develop(&samples);
    }
    let again = Film {
        progress: &|done| {
            (film.progress)(Done {
                pixels: done.pixels / 2,
                ..done
            })
        },
        ..*film
    };
    again.expose(&|x, y, _| {
        let share = (deviation(film, &begun, x, y) / RESTLESS).min(1.0);
        let count = (share * all as f32).ceil() as usize;
        let count = count.max(first).next_power_of_two().min(all);
        let rest = (first..count).map(|i| seen(film, [x, y], i, radiance));
        let (rest, rays) = Gathered::of(film, rest);
        let samples = begun[y * film.width + x].samples.clone();
        (samples.and(&rest), rays)
    })
}
// ANCHOR_END: refine

/// The place of sample i in the pixel, and its radiance. A single sample is in the middle of the pixel.
fn seen(film: &Film, pixel: [usize; 2], i: usize, radiance: &Radiance) -> (Vec2, Followed) {
    let mut numbers = Even::of_pixel(film.seed, pixel, i, film.samples);
    let spread = numbers.pair();
    let p = if film.samples == 1 {
        Vec2::splat(0.5)
    } else {
        spread
    };
    (p, radiance(film.place(pixel, p), &mut numbers))
}

impl Begun {
    /// By the first samples; also the number of their rays.
    fn by(film: &Film, seen: &[(Vec2, Followed)]) -> (Self, u64) {
        let n = seen.len() as f32;
        // The square root approximates the sRGB curve of a display.
        let shown = seen.iter().map(|(_, s)| s.radiance);
        let shown = shown.map(|radiance| radiance.map(|v| v.clamp(0.0, 1.0).sqrt()));
        let shown: ArrayVec<Rgb, FIRST> = shown.collect();
        let mean = shown.iter().copied().sum::<Rgb>() / n;
        let squares = shown
            .iter()
            .map(|v| (*v + mean * -1.0).map(|off| off * off));
        let variance = squares.sum::<Rgb>() / (n - 1.0).max(1.0);
        let variance = variance.max_channel().max(0.0); // a NaN does not count
        let (samples, rays) = Gathered::of(film, seen.iter().copied());
        let begun = Self {
            samples,
            mean,
            variance,
        };
        (begun, rays)
    }
}

/// The root of the mean variance of a pixel and its neighbours, each variance around the pixel's own mean, or of half of the variance
/// of these means if that is larger: where an edge is near the border of pixels, all first samples may lie on one side of it. At
/// most other edges the mean variance is larger than the half.
fn deviation(film: &Film, begun: &[Begun], x: usize, y: usize) -> f32 {
    let (mut within, mut sum, mut squares, mut pixels) = (0.0, Rgb::BLACK, Rgb::BLACK, 0.0);
    for [x, y] in around([x, y], 1, [film.width, film.height]) {
        let Begun { mean, variance, .. } = begun[y * film.width + x];
        within += variance;
        sum += mean;
        squares += mean * mean;
        pixels += 1.0;
    }
    let mean = sum / pixels;
    let between = (squares / pixels + mean * mean * -1.0).max_channel();
    (within / pixels).max(0.5 * between).sqrt()
}
