//! The samples of each pixel, and the filter that makes the picture of them.
//!
//! ```
//! use raybook::prelude::*;
//! use raybook::sample::filter::Filter;
//!
//! // An edge between two pixels is sharp with a box; a tent also counts the samples of the next pixel.
//! let edge = |place: Vec2, _: &mut _| Rgb::gray(if place.x < 0.5 { 0.0 } else { 1.0 });
//! let sharp = Film::new(4, 1, 64);
//! let soft = Film { filter: Filter::TENT, ..sharp };
//! assert_eq!(sharp.sample(edge).at(2, 0), Rgb::WHITE);
//! assert!((soft.sample(edge).at(2, 0).g - 7.0 / 8.0).abs() < 0.01);
//! ```

use crate::image::{Image, around, rgb::Rgb};
use crate::render::film::{Done, Film, Pixel};
use crate::render::followed::Followed;
use glam::{DVec3, Vec2, Vec3, vec2};

/// Σ w L, channel by channel, and Σ w of samples. Sums of `f32` would lose what many samples add.
#[derive(Clone, Copy, Debug, Default)]
struct Weighted {
    light: DVec3,
    weights: f64,
}

impl Weighted {
    /// Adds a sample of this weight.
    fn add(&mut self, light: Rgb, weight: f32) {
        let weight = f64::from(weight);
        self.light += weight * Vec3::from(light.channels()).as_dvec3();
        self.weights += weight;
    }

    /// Adds the sums of other samples, times a number.
    fn add_sums(&mut self, other: &Self, times: f64) {
        self.light += times * other.light;
        self.weights += times * other.weights;
    }

    /// Σ w L/Σ w; black if the sum of the weights is 0.
    fn mean(self) -> Rgb {
        if self.weights == 0.0 {
            Rgb::BLACK
        } else {
            let [r, g, b] = (self.light / self.weights).as_vec3().to_array();
            Rgb::new(r, g, b)
        }
    }
}

/// What the samples of a pixel are for the pixel itself, and for others that the film's filter reaches.
#[derive(Clone, Debug, Default)]
pub(crate) struct Gathered {
    /// Number of samples.
    count: usize,
    /// For the pixel itself.
    own: Weighted,
    /// For the pixels around, row by row, with the pixel itself in the middle; empty if the filter is no wider than a pixel.
    around: Vec<Weighted>,
}

impl Gathered {
    /// By these samples, each with its point of the pixel, in [0, 1)²; also the number of their rays.
    pub(crate) fn of(film: &Film, samples: impl Iterator<Item = (Vec2, Followed)>) -> (Self, u64) {
        let (mut gathered, mut rays) = (Self::default(), 0);
        let reach = film.filter.reach();
        if reach > 0 {
            gathered.around = vec![Weighted::default(); (2 * reach + 1).pow(2)];
        }
        for (p, seen) in samples {
            gathered.count += 1;
            rays += seen.rays;
            if film.filter.is_box() {
                gathered.own.add(seen.radiance, 1.0);
                continue;
            }
            let add = |to: &mut Weighted, offset: Vec2| {
                let weight = film.filter.weight(offset);
                to.add(seen.radiance, weight);
            };
            add(&mut gathered.own, p - 0.5);
            for (i, to) in gathered.around.iter_mut().enumerate() {
                let [x, y] = [i % (2 * reach + 1), i / (2 * reach + 1)];
                let pixel = vec2(x as f32, y as f32) - reach as f32;
                add(to, p - 0.5 - pixel);
            }
        }
        (gathered, rays)
    }

    /// These samples and further ones of the same pixel.
    pub(crate) fn and(mut self, rest: &Self) -> Self {
        self.count += rest.count;
        self.own.add_sums(&rest.own, 1.0);
        for (to, more) in self.around.iter_mut().zip(&rest.around) {
            to.add_sums(more, 1.0);
        }
        self
    }
}

impl Film<'_> {
    /// The picture of the samples that `pixel` gathers for each column and row.
    pub(crate) fn expose(&self, pixel: &Pixel<Gathered>) -> Image {
        if self.filter.reach() == 0 {
            return self.draw(&|x, y, rng| {
                let (gathered, rays) = pixel(x, y, rng);
                (gathered.own.mean(), rays)
            });
        }
        self.develop(&self.each_pixel(pixel))
    }

    /// The picture of all pixels' samples, row by row.
    ///
    /// Each pixel counts by its area, however many samples it has (Mitchell 1987): otherwise a pixel with many samples, on an
    /// edge, would spread over neighbours with few.
    pub(crate) fn develop(&self, all: &[Gathered]) -> Image {
        let size = [self.width, self.height];
        let at = |x: usize, y: usize| &all[y * self.width + x];
        let reach = self.filter.reach();
        if reach == 0 {
            return Image::from_fn(self.width, self.height, |x, y| at(x, y).own.mean());
        }
        // Its pixels are counted already; it goes on as long as the film does.
        let average = Film {
            progress: &|_| (self.progress)(Done::default()),
            ..*self
        };
        average.render_pixels(|x, y, _| {
            let mut sum = Weighted::default();
            for [i, j] in around([x, y], reach, size) {
                let place = (y + reach - j) * (2 * reach + 1) + (x + reach - i);
                // A pixel that was not drawn, because the film was ended, has no samples.
                if let Some(part) = at(i, j).around.get(place) {
                    let area = 1.0 / at(i, j).count.max(1) as f64;
                    sum.add_sums(part, area);
                }
            }
            sum.mean()
        })
    }
}
