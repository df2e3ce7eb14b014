//! Light from all directions, stored in a picture.
//!
//! ```
//! use raybook::prelude::*;
//!
//! // A sky whose upper half shines: with 2 rows of texels, the density is uniform over a hemisphere.
//! let sky = Environment::new(Image::from_fn(4, 2, |_, y| if y == 0 { Rgb::WHITE } else { Rgb::BLACK }));
//! assert_eq!(sky.radiance(-Dir3::Y), Rgb::BLACK);
//! assert!((sky.density(Dir3::Y) - 1.0 / std::f32::consts::TAU).abs() < 1e-5);
//! assert!(sky.choose(vec2(0.3, 0.9)).is_some_and(|toward| toward.y > 0.0));
//! ```

pub mod angular;
pub mod convert;
pub mod cube;
pub mod latlong;

use crate::image::{Image, rgb::Rgb};
use crate::light::{Light, LightHit, LightSample, extent::shine};
use crate::math::piecewise::Piecewise;
use crate::math::{dir3::Dir3, ray::Ray};
use glam::{Vec2, Vec3};
use std::f64::consts::TAU;

/// An environment light: a picture of all directions, infinitely far away. Every texel is a light (Blinn and Newell 1976).
///
/// The layout of the picture is that of [`latlong`]. The radiance is constant within a texel, so that the luminance that is
/// seen and the density of the samples are exactly proportional.
#[derive(Clone, Debug)]
pub struct Environment {
    map: Image,
    /// The probability of each row: its share of all light.
    rows: Piecewise,
    /// The probability of each texel in its row: its share of the row's light.
    columns: Vec<Piecewise>,
    /// cos θ at the rows' edges, from 1 to −1.
    edges: Vec<f64>,
    /// The luminance of all directions, ∫ L dω; above 0 even for a black map, because it is a divisor.
    light: f64,
}

impl Environment {
    /// An environment from a latitude–longitude map; a channel that is negative or not finite counts as 0.
    ///
    /// # Panics
    /// If the map has no texel.
    #[track_caller]
    pub fn new(mut map: Image) -> Self {
        let (width, height) = (map.width(), map.height());
        assert!(width * height > 0, "a map of directions has texels");
        let light = |v: f32| if v.is_finite() { v.max(0.0) } else { 0.0 };
        for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
            map.set(x, y, map.at(x, y).map(light));
        }
        let columns: Vec<_> = (0..height)
            .map(|y| Piecewise::new((0..width).map(|x| f64::from(map.at(x, y).luminance()))))
            .collect();
        let edges: Vec<_> = (0..=height)
            .map(|row| latlong::cosine(row, height))
            .collect();
        let zones = edges.windows(2).map(|edges| edges[0] - edges[1]);
        let light = columns
            .iter()
            .zip(zones)
            .map(|(columns, zone)| columns.total() * zone);
        let rows = Piecewise::new(light);
        Self {
            light: (rows.total() * TAU / width as f64).max(f64::MIN_POSITIVE),
            rows,
            columns,
            edges,
            map,
        }
    }

    /// The map.
    pub fn map(&self) -> &Image {
        &self.map
    }

    /// The radiance that comes from a direction, in W·m⁻²·sr⁻¹.
    pub fn radiance(&self, toward: Dir3) -> Rgb {
        let (x, y) = self.texel(toward);
        self.map.at(x, y)
    }

    // ANCHOR: sample_environment
    /// A direction for u in [0, 1)², with a density proportional to the luminance; `None` if the map is black.
    ///
    /// u.y chooses a row, with a probability proportional to the sum of its luminances times the solid angle of one of its
    /// texels. u.x chooses a texel of the row by its luminance. What the choices leave of u places the direction in the texel,
    /// uniformly over its solid angle: φ and cos θ are uniform, not θ (Archimedes: a zone of a sphere has the same area as the
    /// zone of the same height on the cylinder around the sphere).
    pub fn choose(&self, u: Vec2) -> Option<Dir3> {
        let row = self.rows.choose(u.y)?;
        let column = self.columns[row.cell].choose(u.x)?;
        let (top, bottom) = (self.edges[row.cell], self.edges[row.cell + 1]);
        let cosine = top + (bottom - top) * f64::from(row.within);
        let turn = (column.cell as f32 + column.within) / self.map.width() as f32;
        Some(latlong::toward(turn, cosine))
    }
    // ANCHOR_END: sample_environment

    // ANCHOR: environment_pdf
    /// The density, per steradian, with which [`Environment::choose`] chooses a direction: the probability of the direction's
    /// texel over the texel's solid angle.
    pub fn density(&self, toward: Dir3) -> f32 {
        let (x, y) = self.texel(toward);
        (self.probability(x, y) / self.solid_angle(y)) as f32
    }
    // ANCHOR_END: environment_pdf

    /// The probability with which a texel is chosen.
    fn probability(&self, x: usize, y: usize) -> f64 {
        self.rows.probability(y) * self.columns[y].probability(x)
    }

    /// The solid angle of one texel of a row, in steradians: 2π (cos θ₀ − cos θ₁)/width, its share of the zone between two
    /// circles of latitude.
    fn solid_angle(&self, row: usize) -> f64 {
        TAU * (self.edges[row] - self.edges[row + 1]) / self.map.width() as f64
    }

    /// The radiance that comes from a direction, and the density of the direction, [`Environment::density`]. The texel's solid
    /// angle is a factor of its probability too, and cancels: the density is the texel's luminance over ∫ L dω of all directions.
    fn shines(&self, toward: Dir3) -> (Rgb, f32) {
        let (x, y) = self.texel(toward);
        let radiance = self.map.at(x, y);
        let density = f64::from(radiance.luminance()) / self.light;
        (radiance, density as f32)
    }

    fn texel(&self, toward: Dir3) -> (usize, usize) {
        let (width, height) = (self.map.width(), self.map.height());
        let place = latlong::place(toward);
        let texel = |x: f32, n: usize| ((x * n as f32) as usize).min(n - 1);
        (texel(place.x, width), texel(place.y, height))
    }
}

impl Light for Environment {
    /// Radiance and density are both looked up for the direction. At a texel's edge, by rounding, the direction may belong to the
    /// neighbour of the texel that was chosen: the sun's radiance over a dark neighbour's density would be a firefly.
    fn sample(&self, _at: Vec3, u: Vec2) -> Option<LightSample> {
        let toward = self.choose(u)?;
        let (radiance, pdf) = self.shines(toward);
        shine(toward, f32::INFINITY, radiance, pdf)
    }

    fn seen(&self, ray: &Ray, farthest: f32) -> Option<LightHit> {
        (farthest == f32::INFINITY).then(|| {
            let (radiance, pdf) = self.shines(ray.direction);
            LightHit {
                t: farthest,
                radiance,
                pdf,
            }
        })
    }
}
