//! Adaptive supersampling: a few samples in each pixel, and more where these samples differ.
//!
//! ```
//! use raybook::prelude::*;
//! use raybook::render::{adaptive::{Limits, adaptive}, needs_more::StoppingRule};
//!
//! // The left half of the picture is white, the right half black: only the pixels on the edge need more than 4 samples.
//! let half = |place: Vec2, _: &mut _| if place.x < 0.5 { Rgb::WHITE } else { Rgb::BLACK };
//! let limits = Limits { first: 4, most: 64 };
//! let result = adaptive(&Film::new(5, 1, 64), limits, &StoppingRule::BY_CONTRAST, half);
//! assert_eq!([0, 2, 4].map(|x| result.spent.at(x, 0).g), [4.0, 64.0, 4.0]);
//! assert_eq!(result.mean(), 16.0);
//! ```

use crate::image::{Image, around, rgb::Rgb};
use crate::math::pcg::Pcg;
use crate::render::budget::spend_budget;
use crate::render::film::{Done, Film};
use crate::render::followed::Followed;
use crate::render::needs_more::StoppingRule;
use crate::render::supersample::Radiance;
use crate::sample::even::Even;
use glam::Vec2;
use rand::RngExt;

/// Numbers of samples are below this power of two, on which the order of a pixel's samples depends.
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
    /// From the radiance of each pixel, and the number of its samples.
    fn of(film: &Film, pixels: &[(Rgb, usize)]) -> Self {
        let pixel = |x: usize, y: usize| pixels[y * film.width + x];
        Self {
            picture: Image::from_fn(film.width, film.height, |x, y| pixel(x, y).0),
            spent: Image::from_fn(film.width, film.height, |x, y| {
                Rgb::gray(pixel(x, y).1 as f32)
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
/// The places of a pixel's samples are the beginning of one Sobol sequence with Owen's scrambling ([`Even`]): so all of them
/// together are as even as if their number had been known before.
pub fn adaptive<S: Into<Followed>>(
    film: &Film,
    limits: Limits,
    enough: &StoppingRule,
    radiance: impl Radiance<S>,
) -> Adaptive {
    let most = limits.most.max(1);
    let pixels = film.each_pixel(&|x, y, rng| {
        let point = points(rng);
        let (mut seen, mut goal) = (Vec::new(), limits.first.clamp(1, most));
        let mut rays = 0;
        loop {
            for i in seen.len()..goal {
                let sample: Followed = radiance(film.place([x, y], point(i)), rng).into();
                seen.push(sample.radiance);
                rays += sample.rays;
            }
            if goal == most || !enough.needs_more(&seen) {
                break;
            }
            goal = (2 * goal).min(most);
        }
        let mean = seen.iter().copied().sum::<Rgb>() / seen.len() as f32;
        ((mean, seen.len()), rays)
    });
    Adaptive::of(film, &pixels)
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
        let points = (0..first).map(points(rng));
        let see = |p| radiance(film.place([x, y], p), rng).into();
        let seen: Vec<Followed> = points.map(see).collect();
        let sum = seen.iter().copied().sum::<Followed>();
        ((sum.radiance, deviation(&seen)), sum.rays)
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
        let points = (first..count).map(points(rng));
        let rest = points.map(|p| radiance(film.place([x, y], p), rng).into());
        let rest: Followed = rest.sum();
        let mean = (begun[i].0 + rest.radiance) / count as f32;
        ((mean, count), rest.rays)
    });
    Adaptive::of(film, &pixels)
}
// ANCHOR_END: by_budget

/// The standard deviation of the samples' luminance.
fn deviation(seen: &[Followed]) -> f32 {
    let n = seen.len() as f32;
    let mean = seen.iter().map(|s| s.radiance.luminance()).sum::<f32>() / n;
    let squares: f32 = seen
        .iter()
        .map(|s| (s.radiance.luminance() - mean).powi(2))
        .sum();
    (squares / (n - 1.0)).sqrt()
}

/// The points of a pixel, in [0, 1)², for as many samples as it will get.
fn points(rng: &mut Pcg) -> impl Fn(usize) -> Vec2 + use<> {
    let key = rng.random();
    move |i| Even::new(key, i, MOST).pair()
}
