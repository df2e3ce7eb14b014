//! The map: its texels, their light, and its drawing.

use crate::explain::diagram::{Diagram, Ink};
use crate::explain::way::Way;
use glam::{DVec2, DVec3, dvec2};
use std::f64::consts::{PI, TAU};

/// A latitude-longitude map with the probabilities of its texels.
pub struct Map {
    pub width: usize,
    pub height: usize,
    /// Each texel's radiance times its solid angle, row by row.
    light: Vec<f64>,
}

impl Map {
    pub fn new(width: u32, height: u32, texels: &[f32]) -> Self {
        let (width, height) = (width.max(1) as usize, height.max(1) as usize);
        let of = |i: usize| f64::from(texels.get(i).copied().unwrap_or(0.0)).max(0.0);
        let mut map = Self {
            width,
            height,
            light: Vec::new(),
        };
        map.light = (0..width * height)
            .map(|i| of(i) * map.solid_angle(i / width))
            .collect();
        map
    }

    /// The cosines of θ at a row's edges, the upper one first.
    pub fn edges(&self, row: usize) -> [f64; 2] {
        [row, row + 1].map(|edge| (PI * edge as f64 / self.height as f64).cos())
    }

    /// The solid angle of each texel of a row.
    pub fn solid_angle(&self, row: usize) -> f64 {
        let [top, bottom] = self.edges(row);
        TAU * (top - bottom) / self.width as f64
    }

    /// The light of all texels, as a step of the way.
    pub fn all_told(&self, way: &mut Way) -> f64 {
        way.number(
            "the sum of radiance times solid angle over all texels",
            "W/m²",
            self.light.iter().sum(),
        )
    }

    pub fn of_row(&self, row: usize) -> &[f64] {
        &self.light[row * self.width..(row + 1) * self.width]
    }

    /// Draws the texels' edges, and the values where there are few of them.
    pub fn draw(&self, drawing: &mut Diagram, texels: &[f32]) {
        /// More texels than these have no room for their values.
        const NAMED: usize = 40;
        /// More lines than these are a grey area.
        const LINES: usize = 64;
        let (width, height) = (self.width as f64, self.height as f64);
        let at = |u: f64, v: f64| dvec2(2.0 * u, -v);
        for i in (0..=self.width).filter(|i| self.width <= LINES || i % self.width == 0) {
            let u = i as f64 / width;
            drawing.line(&[at(u, 0.0), at(u, 1.0)], Ink::Guide);
        }
        for i in (0..=self.height).filter(|i| self.height <= LINES || i % self.height == 0) {
            let v = i as f64 / height;
            drawing.line(&[at(0.0, v), at(1.0, v)], Ink::Guide);
        }
        for (i, value) in texels.iter().enumerate().take(self.light.len()) {
            if self.light.len() <= NAMED {
                let (x, y) = ((i % self.width) as f64, (i / self.width) as f64);
                let middle = at((x + 0.5) / width, (y + 0.5) / height);
                drawing.label(middle, DVec2::ZERO, format!("{value:.3}"), Ink::Guide);
            }
        }
    }
}

/// The place of a direction on a latitude-longitude map, as it is drawn: twice as wide as it is high.
pub fn on_map(d: DVec3) -> DVec2 {
    let theta = d.x.hypot(d.z).atan2(d.y);
    dvec2(2.0 * (0.5 + d.x.atan2(-d.z) / TAU), -theta / PI)
}
