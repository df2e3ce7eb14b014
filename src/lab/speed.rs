//! How many rays a structure answers in a second.

use crate::accel::Accel;
use crate::math::{interval::Interval, ray::Ray};
use crate::render::film::Film;
use crate::shape::mesh::Facet;
use glam::{Vec2, vec2};
use std::hint::black_box;
use std::time::Instant;

/// Millions of rays through the middles of a film's pixels that one thread answers in a second; "1.23 million rays a second".
pub fn rays_a_second(film: &Film, ray: impl Fn(Vec2) -> Ray, accel: &impl Accel<Facet>) -> String {
    let size = vec2(film.width as f32, film.height as f32);
    let pixels = (0..film.height).flat_map(|y| (0..film.width).map(move |x| (x, y)));
    let rays: Vec<_> = pixels
        .map(|(x, y)| ray((vec2(x as f32, y as f32) + 0.5) / size))
        .collect();
    let start = Instant::now();
    for ray in &rays {
        black_box(accel.closest(ray, Interval::AHEAD));
    }
    let a_second = rays.len() as f64 / start.elapsed().as_secs_f64();
    format!("{:.2} million rays a second", 1e-6 * a_second)
}
