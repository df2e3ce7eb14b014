//! Adaptive supersampling: a few samples in each pixel, and more where these samples differ.
//!
//! ```
//! use raybook::prelude::*;
//! use raybook::render::{adaptive::{Limits, adaptive}, needs_more::StoppingRule};
//!
//! // The left half of the picture is white, the right half black: only the pixels on the edge need more than 4 samples.
//! let limits = Limits { first: 4, most: 64 };
//! let result = adaptive(&Film::new(5, 1, 64), limits, &StoppingRule::BY_CONTRAST, |place, _| {
//!     if place.x < 0.5 { Rgb::WHITE } else { Rgb::BLACK }
//! });
//! assert_eq!([0, 2, 4].map(|x| result.spent.at(x, 0).g), [4.0, 64.0, 4.0]);
//! assert_eq!(result.mean(), 16.0);
//! ```

use crate::image::{Image, around, rgb::Rgb};
use crate::math::pcg::Pcg;
use crate::render::budget::spend_budget;
use crate::render::film::{Done, Film};
use crate::render::needs_more::StoppingRule;
use crate::render::supersample::Radiance;
use crate::render::{followed::Followed, gather::Gathered};
use crate::sample::even::Even;
use glam::Vec2;
use rand::RngExt;

/// Length of the sequence of which a pixel takes the first samples: more than any pixel takes. It is the same for all pixels, so that the
/// samples do not depend on how many will follow.
const MOST: usize = 1 << 31;

/// A picture, and the number of samples of each pixel.
#[derive(Clone, Debug)]
pub struct Adaptive {
    /// The picture.
    pub picture: Image,
    /// The number of samples of each pixel, the same in every channel.
    pub spent: Image,
}

impl Adaptive {
    /// Of the samples of each pixel, and their number.
    fn of(film: &Film, pixels: Vec<(Gathered, usize)>) -> Self {
        let (samples, counts): (Vec<_>, Vec<_>) = pixels.into_iter().unzip();
        Self {
            picture: film.develop(&samples),
            spent: Image::from_fn(film.width, film.height, |x, y| {
                Rgb::gray(counts[y * film.width + x] as f32)
            }),
        }
    }

    /// The mean number of samples per pixel.
    pub fn mean(&self) -> f64 {
        let counts = self.spent.pixels().iter().map(|p| f64::from(p.r));
        counts.sum::<f64>() / self.spent.pixels().len().max(1) as f64
    }
}

/// Minimum and maximum number of samples per pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Minimum number of samples per pixel, which are taken first. 2 or more are useful: a single sample shows no difference, so
    /// a pixel with `first` = 1 always gets a second sample.
    pub first: usize,
    /// Maximum number of samples per pixel; 0 counts as 1.
    pub most: usize,
}

// ANCHOR: adaptive
/// Each pixel gets `limits.first` samples, and their number is doubled until the [`StoppingRule`] is kept (Whitted 1980; Mitchell
/// 1987).
///
/// A pixel's samples follow each other in one Sobol sequence with Owen's scrambling ([`Even`]): so all of them together are as even
/// as if their number had been known before.
pub fn adaptive<S: Into<Followed>>(
    film: &Film,
    limits: Limits,
    enough: &StoppingRule,
    radiance: impl Radiance<S>,
) -> Adaptive {
    let most = limits.most.max(1);
    let pixels = film.each_pixel(&|x, y, rng| {
        let see = samples(film, [x, y], rng, &radiance);
        let (mut seen, mut looks) = (Vec::new(), Vec::new());
        let mut goal = limits.first.clamp(1, most);
        loop {
            seen.extend((seen.len()..goal).map(&see));
            looks.extend(seen[looks.len()..].iter().map(|(_, s)| s.radiance));
            if goal == most || !enough.needs_more(&looks) {
                break;
            }
            goal = (2 * goal).min(most);
        }
        let count = seen.len();
        let (samples, rays) = Gathered::of(film, seen.into_iter());
        ((samples, count), rays)
    });
    Adaptive::of(film, pixels)
}
// ANCHOR_END: adaptive

// ANCHOR: by_budget
/// A picture with `mean` samples per pixel on average, distributed by the standard deviation of the `first` samples of each pixel
/// (at least 2).
///
/// A pixel's standard deviation is the largest among its 3 × 3 neighbourhood, because its own few samples may have missed an
/// edge.
pub fn by_budget<S: Into<Followed>>(
    film: &Film,
    first: usize,
    mean: usize,
    radiance: impl Radiance<S>,
) -> Adaptive {
    let first = first.max(2);
    let begun = film.each_pixel(&|x, y, rng| {
        let seen: Vec<_> = (0..first)
            .map(samples(film, [x, y], rng, &radiance))
            .collect();
        let deviation = deviation(&seen);
        let (samples, rays) = Gathered::of(film, seen.into_iter());
        ((samples, deviation), rays)
    });
    let (width, size) = (film.width, [film.width, film.height]);
    let largest: Vec<_> = (0..begun.len())
        .map(|i| {
            let near = around([i % width, i / width], 1, size);
            near.map(|[x, y]| begun[y * width + x].1)
                .fold(0.0, f32::max)
        })
        .collect();
    let budget = u32::try_from(mean.saturating_mul(largest.len())).unwrap_or(u32::MAX);
    let counts = spend_budget(&largest, first as u32, budget);
    // The first pass has already reported every pixel as done.
    let again = Film {
        progress: &|done| (film.progress)(Done { pixels: 0, ..done }),
        ..*film
    };
    let pixels = again.each_pixel(&|x, y, rng| {
        let i = y * width + x;
        let count = counts[i] as usize;
        let rest = (first..count).map(samples(film, [x, y], rng, &radiance));
        let (rest, rays) = Gathered::of(film, rest);
        ((begun[i].0.clone().and(&rest), count), rays)
    });
    Adaptive::of(film, pixels)
}
// ANCHOR_END: by_budget

/// The standard deviation of the samples' luminance.
fn deviation(seen: &[(Vec2, Followed)]) -> f32 {
    let n = seen.len() as f32;
    let luminance = || seen.iter().map(|(_, s)| s.radiance.luminance());
    let mean = luminance().sum::<f32>() / n;
    let squares: f32 = luminance().map(|l| (l - mean).powi(2)).sum();
    (squares / (n - 1.0)).sqrt()
}

/// The samples of a pixel, for as many as it will get: the point of the pixel, in [0, 1)², and what is seen there.
fn samples<S: Into<Followed>>(
    film: &Film,
    pixel: [usize; 2],
    rng: &mut Pcg,
    radiance: &impl Radiance<S>,
) -> impl Fn(usize) -> (Vec2, Followed) {
    let key = rng.random();
    move |i| {
        let mut numbers = Even::new(key, i, MOST);
        let p = numbers.pair();
        (p, radiance(film.place(pixel, p), &mut numbers).into())
    }
}
