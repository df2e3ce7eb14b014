//! The film loop: every pixel asks for the radiance of its samples and keeps their mean.
//!
//! ```
//! use raybook::prelude::*;
//!
//! // The mean over a pixel of the place on the film is the pixel's middle.
//! let film = Film::new(4, 1, 16);
//! let picture = film.sample(|place, _| Rgb::gray(place.x));
//! assert!((picture.at(3, 0).g - 3.5 / 4.0).abs() < 0.02);
//! // One thread or eight: the same picture, bit for bit.
//! let by_eight = Film { threads: 8, ..film }.sample(|place, _| Rgb::gray(place.x));
//! assert!(by_eight.same_bits(&picture));
//! ```

use crate::image::{
    Image,
    denoise::{Guide, denoise_while},
    rgb::Rgb,
};
use crate::math::pcg::{self, Pcg};
use crate::memory::gigabytes;
use crate::render::{followed::Followed, gather::Gathered};
use crate::sample::filter::Filter;
use crate::sample::pattern::sobol::{sobol, unit};
use crate::threads;
use glam::{Vec2, vec2};
use rand::RngExt;
use std::fmt;
use std::ops::{ControlFlow, Range};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread::available_parallelism;

/// Edge of a tile in pixels: small enough to distribute the work evenly, large enough that threads seldom fetch a tile.
const TILE: usize = 16;

/// The size of a picture, its samples per pixel, and how the work is done.
#[derive(Clone, Copy)]
pub struct Film<'a> {
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Samples per pixel, at least 1; a power of two is spread most evenly.
    pub samples: usize,
    /// The seed of all random numbers.
    pub seed: u64,
    /// The filter by which the samples become pixels. One that is wider than a pixel takes memory: 32 bytes for each pixel in its reach.
    pub filter: Filter,
    /// Number of threads, at least 1; the picture does not depend on it.
    pub threads: usize,
    /// Called from any thread whenever some pixels are done; returns whether to go on.
    pub progress: &'a Progress<'a>,
}

/// Gets the pixels that have just been done, 16 at most, and returns whether to go on. After a `Break` the thread that asked ends,
/// no more tiles are begun, and missing pixels stay black.
pub type Progress<'a> = dyn Fn(Done) -> ControlFlow<()> + Sync + 'a;

/// Reports nothing, and goes on to the end.
pub const SILENT: &Progress<'static> = &|_| ControlFlow::Continue(());

impl fmt::Debug for Film<'_> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("Film")
            .field("width", &self.width)
            .field("height", &self.height)
            .field("samples", &self.samples)
            .field("seed", &self.seed)
            .field("filter", &self.filter.name)
            .field("threads", &self.threads)
            .finish_non_exhaustive()
    }
}

/// A part of a picture that is done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Done {
    /// Number of pixels in it.
    pub pixels: usize,
    /// Number of rays that were followed for these pixels, as far as they were counted.
    pub rays: u64,
}

/// Computes a pixel from its column, its row and its random numbers; also returns the number of rays that were followed.
pub type Pixel<'a, T> = dyn Fn(usize, usize, &mut Pcg) -> (T, u64) + Sync + 'a;

impl Film<'_> {
    /// A film of `width` × `height` pixels with `samples` samples each, for all processors, with the seed 0, a box as its filter, and
    /// without progress reports.
    ///
    /// # Panics
    /// If the width, the height or the number of samples is 0.
    #[track_caller]
    pub fn new(width: usize, height: usize, samples: usize) -> Self {
        assert!(
            width > 0 && height > 0 && samples > 0,
            "a film of {width} × {height} pixels with {samples} samples each has no picture: all three are at least 1"
        );
        Self {
            width,
            height,
            samples,
            seed: 0,
            filter: Filter::BOX,
            threads: available_parallelism().map_or(1, usize::from),
            progress: SILENT,
        }
    }

    /// The same film with half as many samples per pixel, rounded up.
    #[must_use]
    pub fn halved(&self) -> Self {
        Self {
            samples: self.samples.div_ceil(2),
            ..*self
        }
    }

    /// A denoised picture: `draw` is called twice, each time with half of the samples and other random numbers, and
    /// [`denoise`](crate::image::denoise::denoise) combines the two pictures, guided by what is known of each pixel
    /// ([`Film::guides`]), or by nothing. If drawing was ended, this is the first of the two pictures as it is.
    pub fn denoised(&self, guides: &[Guide], draw: impl Fn(&Self) -> Image) -> Image {
        let half = |seed| {
            draw(&Film {
                seed,
                ..self.halved()
            })
        };
        // Neighbouring seeds must not share a half.
        let halves = [half(self.seed), half(pcg::mix(self.seed))];
        let goes_on = || (self.progress)(Done::default()).is_continue();
        let denoised = denoise_while(&halves, guides, &goes_on);
        let [first, _] = halves;
        if goes_on() { denoised } else { first }
    }

    /// The place on the film, in [0, 1]² from the top left, of a point of the pixel in column x and row y; the point is in [0, 1)² from
    /// the pixel's top left corner.
    pub fn place(&self, [x, y]: [usize; 2], point: Vec2) -> Vec2 {
        (vec2(x as f32, y as f32) + point) / vec2(self.width as f32, self.height as f32)
    }

    /// Width over height.
    pub fn aspect(&self) -> f32 {
        self.width as f32 / self.height as f32
    }

    // ANCHOR: film_loop
    /// The picture whose pixels are the mean of `radiance` over their samples, weighted by the film's filter.
    ///
    /// `radiance` is given the place on the film, in [0, 1]² from the top left, and the pixel's random numbers. It returns an
    /// [`Rgb`], or a [`Followed`] that counts its rays.
    pub fn sample<S: Into<Followed>>(
        &self,
        radiance: impl Fn(Vec2, &mut Pcg) -> S + Sync,
    ) -> Image {
        self.expose(&|x, y, rng| {
            let points = (0..self.samples).map(place_in_pixel(self.samples, rng));
            let see = |p| (p, radiance(self.place([x, y], p), rng).into());
            Gathered::of(self, points.map(see))
        })
    }
    // ANCHOR_END: film_loop

    /// The picture whose pixel in column x and row y is `pixel(x, y, its random numbers)`.
    ///
    /// The threads fetch tiles one by one until none is left. Each pixel has its own stream of random numbers,
    /// so the picture does not depend on which thread draws which pixel.
    pub fn render_pixels<S: Into<Followed>>(
        &self,
        pixel: impl Fn(usize, usize, &mut Pcg) -> S + Sync,
    ) -> Image {
        self.draw(&|x, y, rng| {
            let Followed { radiance, rays } = pixel(x, y, rng).into();
            (radiance, rays)
        })
    }

    // From here on, `pixel` is called through a pointer, so that the loop is compiled once, not once for each closure.

    pub(crate) fn draw(&self, pixel: &Pixel<Rgb>) -> Image {
        let pixels = self.each_pixel(pixel);
        Image::from_fn(self.width, self.height, |x, y| pixels[y * self.width + x])
    }

    /// The first result of `pixel` for each pixel, row by row; the second result is the number of rays that were followed.
    ///
    /// Pixels that are missing, because [`Film::progress`] ended the work, have the default value.
    ///
    /// # Panics
    /// If there is no memory for as many pixels.
    pub fn each_pixel<T: Clone + Default + Send>(&self, pixel: &Pixel<T>) -> Vec<T> {
        let count = self.width.saturating_mul(self.height);
        let mut all = Vec::new();
        let room = all.try_reserve_exact(count);
        let bytes = count.saturating_mul(size_of::<T>());
        assert!(
            room.is_ok(),
            "there is no memory for a film of {} × {} pixels: they take {}",
            self.width,
            self.height,
            gigabytes(bytes as u64)
        );
        all.resize(count, T::default());
        let all = Mutex::new(all);
        self.each_row(&|columns, y| {
            let mut done = Vec::with_capacity(TILE);
            let mut part = Done::default();
            for x in columns.clone() {
                let place = y * self.width + x;
                let (what, rays) = pixel(x, y, &mut pcg::stream(self.seed, place as u64));
                done.push(what);
                part.pixels += 1;
                part.rays += rays;
            }
            let mut all: MutexGuard<Vec<_>> = all.lock().unwrap_or_else(PoisonError::into_inner);
            for (x, what) in columns.zip(done) {
                all[y * self.width + x] = what;
            }
            part
        });
        all.into_inner().unwrap_or_else(PoisonError::into_inner)
    }

    /// Calls `draw` for every row of every tile, with the row's columns and its place, by all threads.
    fn each_row(&self, draw: &(dyn Fn(Range<usize>, usize) -> Done + Sync)) {
        let (columns, rows) = (self.width.div_ceil(TILE), self.height.div_ceil(TILE));
        let next = AtomicUsize::new(0);
        threads::workers(self.threads.clamp(1, (columns * rows).max(1)), &|| {
            loop {
                let tile = next.fetch_add(1, Ordering::Relaxed);
                if tile >= columns * rows {
                    return;
                }
                let (left, top) = (tile % columns * TILE, tile / columns * TILE);
                let (right, bottom) =
                    ((left + TILE).min(self.width), (top + TILE).min(self.height));
                for y in top..bottom {
                    if (self.progress)(draw(left..right, y)).is_break() {
                        next.store(columns * rows, Ordering::Relaxed);
                        return;
                    }
                }
            }
        });
    }
}

/// The place of each sample in its pixel, in [0, 1)².
///
/// A single sample is at the centre. Several samples are Sobol's points: any number of them fills the pixel evenly, and powers of
/// 2 most evenly. Bits of the coordinates are flipped at random, the same bits for all points of a pixel, so that the mean is
/// unbiased (random digit scrambling: Kollig and Keller, "Efficient multidimensional sampling", 2002). Chapter 22 compares
/// patterns.
pub fn place_in_pixel(samples: usize, rng: &mut Pcg) -> impl Fn(usize) -> Vec2 + use<> {
    let flipped: [u32; 2] = [rng.random(), rng.random()];
    move |i| {
        if samples == 1 {
            return Vec2::splat(0.5);
        }
        let [x, y] = sobol(i as u32);
        vec2(unit(x ^ flipped[0]), unit(y ^ flipped[1]))
    }
}
