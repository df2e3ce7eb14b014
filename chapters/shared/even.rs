//! Random numbers that are spread evenly over a pixel's samples: less noise for the same work.

use glam::{Vec2, vec2};
use rand::{RngExt, TryRng};
use raybook::image::Image;
use raybook::math::pcg::Pcg;
use raybook::render::film::{Film, place_in_pixel};
use raybook::render::followed::Followed;
use std::convert::Infallible;

/// So many pairs of numbers are spread: those for the light and for the way on, at a path's first surfaces. What is asked
/// beyond them is random.
const PAIRS: usize = 6;

/// The random numbers of one sample.
///
/// Each pair is a point of a lattice that fills the square evenly, and the samples take its points in a random order of
/// their own for each pair. Each sample by itself is as random as ever, so that means stay what they are.
pub struct Even<'a> {
    numbers: [u32; 2 * PAIRS],
    used: usize,
    rest: &'a mut Pcg,
}

impl TryRng for Even<'_> {
    type Error = Infallible;

    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        let Some(&number) = self.numbers.get(self.used) else {
            return self.rest.try_next_u32();
        };
        self.used += 1;
        Ok(number)
    }

    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        self.rest.try_next_u64()
    }

    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
        self.rest.try_fill_bytes(bytes)
    }
}

/// As [`Film::render`], with random numbers that are spread evenly over the samples of each pixel.
pub fn render<S: Into<Followed>>(
    film: &Film,
    radiance: impl Fn(Vec2, &mut Even) -> S + Sync,
) -> Image {
    let size = vec2(film.width as f32, film.height as f32);
    film.render_pixels(|x, y, rng| {
        let places = place_in_pixel(film.samples, rng);
        let spread: [_; PAIRS] = std::array::from_fn(|_| {
            let points = place_in_pixel(film.samples, rng);
            (shuffled(film.samples, rng), points)
        });
        let sum: Followed = (0..film.samples)
            .map(|i| {
                let mut numbers = [0; 2 * PAIRS];
                for (pair, (order, points)) in numbers.chunks_exact_mut(2).zip(&spread) {
                    let point = points(order[i]);
                    pair.copy_from_slice(&[point.x, point.y].map(bits));
                }
                let mut rng = Even {
                    numbers,
                    used: if film.samples == 1 { 2 * PAIRS } else { 0 }, // one sample is not spread
                    rest: rng,
                };
                let place = vec2(x as f32, y as f32) + places(i);
                radiance(place / size, &mut rng).into()
            })
            .sum();
        sum.mean_of(film.samples)
    })
}

/// The number whose first 24 digits make v, in [0, 1), again.
fn bits(v: f32) -> u32 {
    ((v * (1 << 24) as f32) as u32) << 8
}

/// The numbers from 0 to n − 1 in a random order (Fisher and Yates 1938).
fn shuffled(n: usize, rng: &mut Pcg) -> Vec<usize> {
    let mut order: Vec<_> = (0..n).collect();
    for i in (1..n).rev() {
        order.swap(i, rng.random_range(0..=i));
    }
    order
}
