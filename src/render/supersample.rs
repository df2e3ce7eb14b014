//! Supersampling: several rays per pixel, placed by a pattern and averaged by a filter.
//!
//! ```
//! use raybook::prelude::*;
//! use raybook::render::supersample::supersample;
//! use raybook::sample::pattern::find;
//!
//! // A pixel whose left quarter is white: 16 points of a regular grid find the quarter exactly.
//! let grid = find("regular-grid").expect("a pattern of this name");
//! let quarter = |place: Vec2, _: &mut _| Rgb::gray(if place.x < 0.25 { 1.0 } else { 0.0 });
//! assert_eq!(supersample(&Film::new(1, 1, 16), grid, quarter).at(0, 0), Rgb::gray(0.25));
//! ```

use crate::image::{Image, around};
use crate::math::pcg::Pcg;
use crate::render::film::{Done, Film};
use crate::render::followed::Followed;
use crate::sample::filter::{Filter, Sample, pixel_average};
use crate::sample::pattern::Pattern;
use glam::{Vec2, vec2};

/// A function that returns what a ray through a place on the film, in [0, 1]² from the top left, sees.
pub trait Radiance<S>: Fn(Vec2, &mut Pcg) -> S + Sync {}

impl<S, F: Fn(Vec2, &mut Pcg) -> S + Sync> Radiance<S> for F {}

/// The points of each pixel, in [0, 1)²: `film.samples` points of a [`Pattern`], or those that a function places, which gets the
/// pixel's column, its row and its random numbers.
pub trait Points: Sync {
    /// The points of the pixel in column x and row y.
    fn in_pixel(&self, film: &Film, x: usize, y: usize, rng: &mut Pcg) -> Vec<Vec2>;
}

impl Points for Pattern {
    fn in_pixel(&self, film: &Film, _: usize, _: usize, rng: &mut Pcg) -> Vec<Vec2> {
        (self.points)(film.samples, rng)
    }
}

impl<F: Fn(usize, usize, &mut Pcg) -> Vec<Vec2> + Sync> Points for F {
    fn in_pixel(&self, _: &Film, x: usize, y: usize, rng: &mut Pcg) -> Vec<Vec2> {
        self(x, y, rng)
    }
}

// ANCHOR: supersample
/// The picture whose pixels are the mean of their samples, which are placed by a pattern: a box filter.
///
/// Every pixel has its own random numbers, and so its own points if the pattern is random.
pub fn supersample<S: Into<Followed>>(
    film: &Film,
    points: &impl Points,
    radiance: impl Radiance<S>,
) -> Image {
    film.render_pixels(|x, y, rng| {
        let points = points.in_pixel(film, x, y, rng);
        let seen = points
            .iter()
            .map(|p| radiance(film.place([x, y], *p), rng).into());
        seen.sum::<Followed>().mean_of(points.len().max(1))
    })
}
// ANCHOR_END: supersample

/// As [`supersample`], but each sample counts for all pixels within the filter's radius, with the filter's weight.
///
/// A pixel near the picture's edge has fewer samples; their weights are divided by their sum there too.
pub fn filtered<S: Into<Followed>>(
    film: &Film,
    points: &impl Points,
    filter: &Filter,
    radiance: impl Radiance<S>,
) -> Image {
    let seen = film.each_pixel(&|x, y, rng| {
        let placed = points.in_pixel(film, x, y, rng);
        let mut rays = 0;
        let see = |p| {
            let seen: Followed = radiance(film.place([x, y], p), rng).into();
            rays += seen.rays;
            (p, seen.radiance)
        };
        let samples: Vec<_> = placed.into_iter().map(see).collect();
        (samples, rays)
    });
    // Its pixels are counted already; it goes on as long as the film does.
    let average = Film {
        progress: &|_| (film.progress)(Done::default()),
        ..*film
    };
    let reach = (filter.radius + 0.5).floor() as usize;
    average.render_pixels(|x, y, _| {
        let mut samples = Vec::new();
        for [i, j] in around([x, y], reach, [film.width, film.height]) {
            let corner = vec2(i as f32 - x as f32, j as f32 - y as f32) - 0.5;
            for &(p, radiance) in &seen[j * film.width + i] {
                let offset = corner + p;
                samples.push(Sample { offset, radiance });
            }
        }
        pixel_average(filter, &samples)
    })
}
