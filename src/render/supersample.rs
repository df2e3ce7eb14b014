//! Supersampling: several rays per pixel, placed by a pattern.
//!
//! ```
//! use raybook::prelude::*;
//! use raybook::render::supersample::supersample;
//! use raybook::sample::pattern::find;
//!
//! // A pixel whose left quarter is white: 16 points of a regular grid find the quarter exactly.
//! let grid = find("regular-grid").expect("a pattern of this name");
//! let picture = supersample(&Film::new(1, 1, 16), grid, |place, _| {
//!     Rgb::gray(if place.x < 0.25 { 1.0 } else { 0.0 })
//! });
//! assert_eq!(picture.at(0, 0), Rgb::gray(0.25));
//! ```

use crate::image::Image;
use crate::math::pcg::Pcg;
use crate::render::{film::Film, followed::Followed, gather::Gathered};
use crate::sample::{padded::Padded, pattern::Pattern};
use glam::Vec2;
use rand::Rng;

/// A function that returns what a ray through a place on the film, in [0, 1]² from the top left, sees. All further choices of the
/// sample depend on its random numbers.
pub trait Radiance<S>: Fn(Vec2, &mut dyn Rng) -> S + Sync {}

impl<S, F: Fn(Vec2, &mut dyn Rng) -> S + Sync> Radiance<S> for F {}

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
/// The picture whose samples are placed by a pattern.
///
/// Every pixel has its own random numbers, and so its own points if the pattern is random. A sample's other choices, for example
/// of a point on the lens, are made by further points of the pattern ([`Padded`]).
pub fn supersample<S: Into<Followed>>(
    film: &Film,
    points: &dyn Points,
    radiance: impl Radiance<S>,
) -> Image {
    film.expose(&|x, y, rng| {
        let places = points.in_pixel(film, x, y, rng);
        let mut padded = Padded::new(rng, |rng| points.in_pixel(film, x, y, rng));
        let see = |(i, p)| {
            let seen = radiance(film.place([x, y], p), &mut padded.sample(i));
            (p, seen.into())
        };
        Gathered::of(film, places.into_iter().enumerate().map(see))
    })
}
// ANCHOR_END: supersample
