//! Heat maps: what each pixel's ray costs, with one scale for all accelerators.

use crate::kit::figure::{CENTRE, Figure, SCALE, figure, text, write};
use crate::kit::numbers::grouped;
use crate::kit::palette::viridis;
use crate::kit::sheet::{Sheet, sheet};
use glam::{Vec2, vec2};
use plotters::prelude::{Color, RGBColor, Rectangle};
use raybook::accel::{Accel, Tests};
use raybook::image::{Image, rgb::Rgb, tone};
use raybook::math::{interval::Interval, ray::Ray};
use raybook::render::film::Film;
use raybook::shape::mesh::Facet;

/// The count of the last colour. The scale is logarithmic, because a ray can cost a few tests or thousands.
const MOST: f32 = 1000.0;

/// What one ray through the middle of each pixel costs.
#[derive(Debug)]
pub struct Heat {
    /// Boxes as red, shapes as green.
    counts: Image,
}

/// Sends a ray through the middle of each pixel of the film and counts what the search for its hit tests.
pub fn heat(film: &Film, ray: impl Fn(Vec2) -> Ray + Sync, accel: &impl Accel<Facet>) -> Heat {
    let size = vec2(film.width as f32, film.height as f32);
    let counts = film.render_pixels(|x, y, _| {
        let ray = ray((vec2(x as f32, y as f32) + 0.5) / size);
        let mut tests = Tests::default();
        accel.closest_counted(&ray, Interval::AHEAD, &mut tests);
        Rgb::new(tests.boxes as f32, tests.shapes as f32, 0.0)
    });
    Heat { counts }
}

/// As [`heat`], with one ray for each square of 8 × 8 pixels: for a search that is expensive and costs the same everywhere.
pub fn coarse(film: &Film, ray: impl Fn(Vec2) -> Ray + Sync, accel: &impl Accel<Facet>) -> Heat {
    const SIDE: usize = 8;
    let film = Film {
        width: (film.width / SIDE).max(1),
        height: (film.height / SIDE).max(1),
        ..*film
    };
    let Heat { counts } = heat(&film, ray, accel);
    Heat {
        counts: counts.enlarged(SIDE),
    }
}

impl Heat {
    /// All rays' tests together.
    pub fn tests(&self) -> Tests {
        let sum =
            |count: fn(&Rgb) -> f32| self.counts.pixels().iter().map(|p| count(p) as u64).sum();
        Tests {
            boxes: sum(|p| p.r),
            shapes: sum(|p| p.g),
        }
    }

    /// How many rays there were.
    pub fn rays(&self) -> usize {
        self.counts.pixels().len()
    }

    /// The boxes' map, with a label that says how many there are per ray; `boxes` names them: "cells visited".
    pub fn of_boxes(&self, boxes: &str) -> (String, Image) {
        self.map(boxes, |p| p.r)
    }

    /// The map of the triangles tested, with a label that says how many there are per ray.
    pub fn of_triangles(&self) -> (String, Image) {
        self.map("triangles tested", |p| p.g)
    }

    /// Both maps side by side, and the scale below.
    ///
    /// # Errors
    /// If the labels cannot be drawn.
    pub fn figure(&self, boxes: &str) -> Sheet {
        with_scale(2, &[self.of_boxes(boxes), self.of_triangles()])
    }

    fn map(&self, name: &str, count: fn(&Rgb) -> f32) -> (String, Image) {
        let sum: f64 = self
            .counts
            .pixels()
            .iter()
            .map(|p| f64::from(count(p)))
            .sum();
        let label = match sum / self.rays().max(1) as f64 {
            few if few < 1000.0 => format!("{name}: {few:.1} a ray"),
            many => format!("{name}: {} a ray", grouped(many)),
        };
        (label, self.counts.map(|p| colour(count(&p))))
    }
}

/// Maps in rows of `columns`, each under its label, and the scale below.
///
/// # Errors
/// If the labels cannot be drawn.
pub fn with_scale(columns: usize, maps: &[(String, Image)]) -> Sheet {
    let maps: Vec<_> = maps
        .iter()
        .map(|(label, map)| (label.as_str(), map.clone()))
        .collect();
    let maps = sheet(columns, &maps)?;
    let scale = scale(maps.width() as u32)?;
    Ok(below(&maps, &scale.pixels))
}

/// The colour of a count: light grey for 0, then viridis on a logarithmic scale from 1 to 1000.
pub fn colour(count: f32) -> Rgb {
    if count < 1.0 {
        Rgb::gray(0.85)
    } else {
        viridis(count.ln() / MOST.ln())
    }
}

/// The colours of the counts, with the counts below.
fn scale(width: u32) -> Figure {
    let height = (width / 16).clamp(24, 64);
    figure(width, height, |canvas| {
        let (wide, high) = ((SCALE * width) as f32, (SCALE * height) as f32);
        let (left, right, bottom) = (0.12 * wide, 0.88 * wide, 0.45 * high);
        for x in left as i32..right as i32 {
            let Rgb { r, g, b } = colour(MOST.powf((x as f32 - left) / (right - left)));
            let [r, g, b] = [r, g, b].map(|v| (255.0 * tone::encode_srgb(v)).round() as u8);
            let column = [(x, 0), (x + 1, bottom as i32)];
            canvas.draw(&Rectangle::new(column, RGBColor(r, g, b).filled()))?;
        }
        let label = |words: &str, x: f32| {
            let place = (x as i32, (0.74 * high) as i32);
            write(canvas, words, place, text(0.42 * high).pos(CENTRE))
        };
        for count in [1.0, 3.0, 10.0, 30.0, 100.0, 300.0, MOST] {
            label(&count.to_string(), left + (right - left) * count.log(MOST))?;
        }
        label("tests:", 0.06 * wide)
    })
}

/// One picture below another of the same width.
fn below(above: &Image, under: &Image) -> Image {
    let split = above.height();
    Image::from_fn(above.width(), split + under.height(), |x, y| {
        if y < split {
            above.at(x, y)
        } else {
            under.at(x, y - split)
        }
    })
}
