//! Rays per second, of one structure in words or of several in bars.

use crate::kit::{
    bars::{Bars, bars},
    figure::Figure,
};
use glam::{Vec2, vec2};
use raybook::accel::Accel;
use raybook::math::{interval::Interval, ray::Ray};
use raybook::render::film::Film;
use raybook::shape::mesh::Facet;
use std::hint::black_box;
use std::time::Instant;

/// A structure's name, and its search: whether the ray hits anything.
pub type Searcher<'a> = (&'a str, &'a dyn Fn(&Ray) -> bool);

/// Number of rounds, in each of which every structure has a turn; the best turn counts.
const ROUNDS: usize = 4;

/// Length of a turn, in seconds: a slow structure does not follow all rays in a turn.
const TURN: f64 = 0.015;

/// A ray through the middle of each pixel of the film, row by row.
pub fn rays(film: &Film, ray: impl Fn(Vec2) -> Ray) -> Vec<Ray> {
    let size = vec2(film.width as f32, film.height as f32);
    let pixels = (0..film.height).flat_map(|y| (0..film.width).map(move |x| (x, y)));
    pixels
        .map(|(x, y)| ray((vec2(x as f32, y as f32) + 0.5) / size))
        .collect()
}

/// Million rays per second of each structure, in their order, on one thread.
pub fn millions(rays: &[Ray], structures: &[Searcher]) -> Vec<f64> {
    let mut best = vec![0.0_f64; structures.len()];
    for _ in 0..ROUNDS {
        for (best, (_, search)) in best.iter_mut().zip(structures) {
            let (start, mut done) = (Instant::now(), 0);
            for some in rays.chunks(64) {
                for ray in some {
                    black_box(search(black_box(ray)));
                }
                done += some.len();
                if start.elapsed().as_secs_f64() > TURN {
                    break;
                }
            }
            *best = best.max(1e-6 * done as f64 / start.elapsed().as_secs_f64().max(1e-9));
        }
    }
    best
}

/// The speed of one structure with the rays of a film: "1.23 million rays a second".
pub fn rays_a_second(film: &Film, ray: impl Fn(Vec2) -> Ray, accel: &impl Accel<Facet>) -> String {
    let search = |ray: &Ray| accel.closest(ray, Interval::AHEAD).is_some();
    let millions = millions(&rays(film, ray), &[("", &search)]);
    format!("{:.2} million rays a second", millions[0])
}

/// A bar for each structure.
///
/// # Errors
/// What plotters reports.
pub fn figure(rays: &[Ray], structures: &[Searcher], note: &str) -> Figure {
    let names = structures.iter().map(|(name, _)| *name);
    let rows: Vec<_> = names.zip(millions(rays, structures)).collect();
    bars(&[Bars {
        title: "Rays per second, one thread",
        unit: "million",
        rows: &rows,
        note,
    }])
}
