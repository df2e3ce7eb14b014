//! The film loop that spares work: few samples where they are alike, all of them where they differ.

use crate::image::Image;
use crate::math::pcg::Pcg;
use crate::render::film::{Done, Film};
use crate::render::followed::Followed;
use crate::sample::even::Even;
use glam::{Vec2, vec2};
use rand::RngExt;

/// The first samples of every pixel: four, or half of all where these are few, but two at least, for one knows no deviation.
fn first_of(all: usize) -> usize {
    (all / 2).clamp(2, 4).min(all)
}

/// The standard deviation, in what a display shows, from which on a pixel gets all its samples.
const RESTLESS: f32 = 0.2;

/// What is seen at a place on the film, by a sample's random numbers.
type Radiance<'a> = dyn Fn(Vec2, &mut Even) -> Followed + Sync + 'a;

/// What the first samples of a pixel tell.
#[derive(Clone, Copy, Default)]
struct Begun {
    sum: Followed,
    /// Of what a display shows, in the channel that has most.
    variance: f32,
}

impl Film<'_> {
    /// The picture whose pixels are the mean of `radiance` over all samples, by numbers that are spread evenly.
    ///
    /// `radiance` is given the place on the film, in [0, 1]² from the top left, and the sample's random numbers.
    pub fn evenly<S: Into<Followed>>(
        &self,
        radiance: impl Fn(Vec2, &mut Even) -> S + Sync,
    ) -> Image {
        all(self, &|place, numbers| radiance(place, numbers).into())
    }

    /// As [`Film::evenly`], but a pixel gets all samples only where they differ most, and fewer, down to four, in proportion to
    /// their standard deviation (Whitted 1980; Neyman 1934).
    ///
    /// The deviation is that of the pixel and its eight neighbours, for an edge may have slipped through between its own few.
    /// What is so small and so rare that they all miss it is not found: where light comes by chance, as in path tracing and
    /// through a lens, take [`Film::evenly`].
    pub fn refine<S: Into<Followed>>(
        &self,
        radiance: impl Fn(Vec2, &mut Even) -> S + Sync,
    ) -> Image {
        refined(self, &|place, numbers| radiance(place, numbers).into())
    }
}

fn all(film: &Film, radiance: &Radiance) -> Image {
    film.render_pixels(|x, y, rng| {
        let sample = Sample::of(film, x, y, rng);
        let sum: Followed = (0..film.samples).map(|i| sample.seen(i, radiance)).sum();
        sum.mean_of(film.samples)
    })
}

// ANCHOR: refine
fn refined(film: &Film, radiance: &Radiance) -> Image {
    let all = film.samples;
    let first = first_of(all);
    let begun = film.each_pixel(&|x, y, rng| {
        let sample = Sample::of(film, x, y, rng);
        let seen: Vec<_> = (0..first).map(|i| sample.seen(i, radiance)).collect();
        let begun = Begun::by(&seen);
        (begun, begun.sum.rays)
    });
    let again = Film {
        progress: &|done| (film.progress)(Done { pixels: 0, ..done }),
        ..*film
    };
    again.render_pixels(|x, y, rng| {
        let sample = Sample::of(film, x, y, rng);
        let share = (deviation(film, &begun, x, y) / RESTLESS).min(1.0);
        let count = (share * all as f32).ceil() as usize;
        let count = count.max(first).next_power_of_two().min(all);
        let rest: Followed = (first..count).map(|i| sample.seen(i, radiance)).sum();
        let sum = begun[y * film.width + x].sum.radiance + rest.radiance;
        Followed {
            radiance: sum / count as f32,
            ..rest
        }
    })
}
// ANCHOR_END: refine

/// The samples of a pixel.
struct Sample<'a> {
    film: &'a Film<'a>,
    /// The pixel's top left corner, in pixels.
    corner: Vec2,
    /// What all its numbers follow from.
    key: u64,
}

impl<'a> Sample<'a> {
    fn of(film: &'a Film<'a>, x: usize, y: usize, rng: &mut Pcg) -> Self {
        Self {
            film,
            corner: vec2(x as f32, y as f32),
            key: rng.random(),
        }
    }

    /// What sample i sees. A single one is in the middle of the pixel.
    fn seen(&self, i: usize, radiance: &Radiance) -> Followed {
        let film = self.film;
        let mut numbers = Even::new(self.key, i, film.samples);
        let spread = numbers.pair();
        let place = if film.samples == 1 {
            Vec2::splat(0.5)
        } else {
            spread
        };
        let size = vec2(film.width as f32, film.height as f32);
        radiance((self.corner + place) / size, &mut numbers)
    }
}

impl Begun {
    fn by(seen: &[Followed]) -> Self {
        let n = seen.len() as f32;
        // The square root is near to the curve by which a display shows light.
        let shown = |channel: usize| {
            let values = seen.iter().map(move |s| s.radiance.channels()[channel]);
            values.map(|v| v.clamp(0.0, 1.0).sqrt())
        };
        let variance = |channel: usize| {
            let mean = shown(channel).sum::<f32>() / n;
            shown(channel).map(|v| (v - mean).powi(2)).sum::<f32>() / (n - 1.0).max(1.0)
        };
        Self {
            sum: seen.iter().copied().sum(),
            variance: (0..3).map(variance).fold(0.0, f32::max),
        }
    }
}

/// The standard deviation of a pixel's samples and its neighbours', each around their own mean.
fn deviation(film: &Film, begun: &[Begun], x: usize, y: usize) -> f32 {
    let near = |v: usize, end: usize| v.saturating_sub(1)..(v + 2).min(end);
    let (xs, ys) = (near(x, film.width), near(y, film.height));
    let pixels = (xs.len() * ys.len()) as f32;
    let variances = ys.flat_map(|y| xs.clone().map(move |x| begun[y * film.width + x].variance));
    (variances.sum::<f32>() / pixels).sqrt()
}
