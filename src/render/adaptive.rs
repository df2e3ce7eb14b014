//! Adaptive supersampling: a few samples in each pixel, and more where these samples differ.

use crate::image::{Image, rgb::Rgb};
use crate::render::budget::spend_budget;
use crate::render::film::{Done, Film};
use crate::render::followed::Followed;
use crate::render::needs_more::StoppingRule;
use crate::render::supersample::Radiance;
use crate::sample::pattern::owen::sequence;
use glam::{Vec2, vec2};
use std::sync::atomic::{AtomicUsize, Ordering};

/// A picture, and the number of samples of each pixel.
#[derive(Clone, Debug)]
pub struct Adaptive {
    /// The picture.
    pub picture: Image,
    /// The number of samples of each pixel, the same in every channel.
    pub spent: Image,
}

impl Adaptive {
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
/// The samples of a pixel are the beginning of one Sobol sequence, scrambled by Owen's method: so all of them together are as
/// even as if their number had been known before.
pub fn adaptive<S: Into<Followed>>(
    film: &Film,
    limits: Limits,
    enough: &StoppingRule,
    radiance: impl Radiance<S>,
) -> Adaptive {
    let most = limits.most.max(1);
    let spent = Counts::new(film);
    let picture = film.render_pixels(|x, y, rng| {
        let point = sequence(rng);
        let (mut seen, mut goal) = (Vec::new(), limits.first.clamp(1, most));
        let mut rays = 0;
        loop {
            for i in seen.len()..goal {
                let sample: Followed = radiance(place(film, x, y, point(i as u32)), rng).into();
                seen.push(sample.radiance);
                rays += sample.rays;
            }
            if goal == most || !enough.needs_more(&seen) {
                break;
            }
            goal = (2 * goal).min(most);
        }
        spent.set(x, y, seen.len());
        let radiance = seen.iter().copied().sum::<Rgb>() / seen.len() as f32;
        Followed { radiance, rays }
    });
    Adaptive {
        picture,
        spent: spent.image(),
    }
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
    let deviations = Counts::new(film);
    let begun = film.render_pixels(|x, y, rng| {
        let points = (0..first as u32).map(sequence(rng));
        let see = |p| radiance(place(film, x, y, p), rng).into();
        let seen: Vec<Followed> = points.map(see).collect();
        deviations.set(x, y, deviation(&seen).to_bits() as usize);
        seen.into_iter().sum::<Followed>()
    });
    let near = |v: usize, end: usize| v.saturating_sub(1)..(v + 2).min(end);
    let of = |x: usize, y: usize| f32::from_bits(deviations.get(x, y) as u32);
    let largest: Vec<_> = (0..film.width * film.height)
        .map(|i| {
            let (xs, ys) = (
                near(i % film.width, film.width),
                near(i / film.width, film.height),
            );
            ys.flat_map(|y| xs.clone().map(move |x| of(x, y)))
                .fold(0.0, f32::max)
        })
        .collect();
    let budget = u32::try_from(mean.saturating_mul(largest.len())).unwrap_or(u32::MAX);
    let counts = spend_budget(&largest, first as u32, budget);
    let count = |x: usize, y: usize| counts[y * film.width + x] as usize;
    // The first pass has already reported every pixel as done.
    let again = Film {
        progress: &|done| (film.progress)(Done { pixels: 0, ..done }),
        ..*film
    };
    let picture = again.render_pixels(|x, y, rng| {
        let points = (first as u32..count(x, y) as u32).map(sequence(rng));
        let rest = points.map(|p| radiance(place(film, x, y, p), rng).into());
        let rest: Followed = rest.sum();
        Followed {
            radiance: (begun.at(x, y) + rest.radiance) / count(x, y) as f32,
            ..rest
        }
    });
    Adaptive {
        picture,
        spent: Image::from_fn(
            film.width,
            film.height,
            |x, y| Rgb::gray(count(x, y) as f32),
        ),
    }
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

/// The place on the film, in [0, 1]², of the point p, in [0, 1)², of pixel (x, y).
fn place(film: &Film, x: usize, y: usize, p: Vec2) -> Vec2 {
    (vec2(x as f32, y as f32) + p) / vec2(film.width as f32, film.height as f32)
}

/// A whole number for each pixel, set by any thread.
struct Counts {
    width: usize,
    height: usize,
    of_pixels: Vec<AtomicUsize>,
}

impl Counts {
    fn new(film: &Film) -> Self {
        Self {
            width: film.width,
            height: film.height,
            of_pixels: (0..film.width * film.height)
                .map(|_| AtomicUsize::new(0))
                .collect(),
        }
    }

    fn set(&self, x: usize, y: usize, count: usize) {
        self.of_pixels[y * self.width + x].store(count, Ordering::Relaxed);
    }

    fn get(&self, x: usize, y: usize) -> usize {
        self.of_pixels[y * self.width + x].load(Ordering::Relaxed)
    }

    fn image(&self) -> Image {
        Image::from_fn(self.width, self.height, |x, y| {
            Rgb::gray(self.get(x, y) as f32)
        })
    }
}
