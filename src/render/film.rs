//! The film loop: every pixel asks for the radiance of its samples and keeps their mean.

use crate::image::{Image, rgb::Rgb};
use crate::math::pcg::{self, Pcg};
use crate::render::followed::Followed;
use crate::threads;
use glam::{Vec2, vec2};
use rand::RngExt;
use std::fmt;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Edge of a tile in pixels: small enough to share the work evenly, large enough to fetch seldom.
const TILE: usize = 16;

/// What a picture is taken on.
#[derive(Clone, Copy)]
pub struct Film<'a> {
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Samples per pixel, at least 1.
    pub samples: usize,
    /// What every random number follows from.
    pub seed: u64,
    /// How many threads work; the picture does not depend on it.
    pub threads: usize,
    /// Told whenever some pixels are done, from any thread.
    pub progress: &'a (dyn Fn(Done) + Sync),
}

impl fmt::Debug for Film<'_> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("Film")
            .field("width", &self.width)
            .field("height", &self.height)
            .field("samples", &self.samples)
            .field("seed", &self.seed)
            .field("threads", &self.threads)
            .finish_non_exhaustive()
    }
}

/// A part of a picture that is done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Done {
    /// Its pixels.
    pub pixels: usize,
    /// The rays that were followed for them, as far as they were counted.
    pub rays: u64,
}

impl Film<'_> {
    /// Width over height.
    pub fn aspect(&self) -> f32 {
        self.width as f32 / self.height as f32
    }

    // ANCHOR: film_loop
    /// The picture whose pixels are the mean of `radiance` over their samples.
    ///
    /// `radiance` is given the place on the film, in [0, 1]² from the top left, and the pixel's random numbers. It returns an
    /// [`Rgb`], or a [`Followed`] that counts its rays.
    pub fn render<S: Into<Followed>>(
        &self,
        radiance: impl Fn(Vec2, &mut Pcg) -> S + Sync,
    ) -> Image {
        self.render_pixels(|x, y, rng| {
            let places = place_in_pixel(self.samples, rng);
            let sum: Followed = (0..self.samples)
                .map(|i| {
                    let place = vec2(x as f32, y as f32) + places(i);
                    radiance(place / vec2(self.width as f32, self.height as f32), rng).into()
                })
                .sum();
            sum.mean_of(self.samples)
        })
    }
    // ANCHOR_END: film_loop

    /// The picture whose pixel in column x and row y is `pixel(x, y, its random numbers)`.
    ///
    /// The threads fetch tiles one by one until none is left; each pixel has its own stream of random numbers,
    /// so the picture does not depend on which thread draws which.
    pub fn render_pixels<S: Into<Followed>>(
        &self,
        pixel: impl Fn(usize, usize, &mut Pcg) -> S + Sync,
    ) -> Image {
        let (columns, rows) = (self.width.div_ceil(TILE), self.height.div_ceil(TILE));
        let next = AtomicUsize::new(0);
        let work = || {
            let mut done = Vec::new();
            loop {
                let tile = next.fetch_add(1, Ordering::Relaxed);
                if tile >= columns * rows {
                    return done;
                }
                let (left, top) = (tile % columns * TILE, tile / columns * TILE);
                let mut part = Done::default();
                for y in top..(top + TILE).min(self.height) {
                    for x in left..(left + TILE).min(self.width) {
                        let mut rng = pcg::stream(self.seed, (y * self.width + x) as u64);
                        let Followed { radiance, rays } = pixel(x, y, &mut rng).into();
                        done.push((x, y, radiance));
                        part.pixels += 1;
                        part.rays += rays;
                    }
                }
                (self.progress)(part);
            }
        };
        let mut picture = Image::from_fn(self.width, self.height, |_, _| Rgb::BLACK);
        let workers = self.threads.clamp(1, (columns * rows).max(1));
        for (x, y, colour) in threads::workers(workers, work).into_iter().flatten() {
            picture.set(x, y, colour);
        }
        picture
    }
}

/// Where in its pixel each sample falls, in [0, 1)².
///
/// One sample is at the centre. More of them are a lattice of irrational steps, which fills the pixel evenly for any
/// number (R₂: Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018), shifted at random per pixel,
/// so that their mean has no bias. Chapter 22 compares it with other patterns.
///
/// The steps are counted in units of 2⁻³², whose overflow drops the whole pixels: in `f32`, i times the step would have
/// lost half its digits after a few thousand samples.
pub fn place_in_pixel(samples: usize, rng: &mut Pcg) -> impl Fn(usize) -> Vec2 + use<> {
    /// (1/ρ, 1/ρ²) · 2³², where ρ³ = ρ + 1.
    const STEP: [u32; 2] = [3_242_174_889, 2_447_445_414];
    let shift: [u32; 2] = [rng.random(), rng.random()];
    move |i| {
        if samples == 1 {
            return Vec2::splat(0.5);
        }
        let along = |axis: usize| {
            let place = shift[axis].wrapping_add(STEP[axis].wrapping_mul(i as u32));
            (place >> 8) as f32 / (1 << 24) as f32 // f32 has 24 digits: with more, this could round to 1
        };
        vec2(along(0), along(1))
    }
}
