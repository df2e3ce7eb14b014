//! The lesson's drawings: a wave that is sampled too coarsely, a pixel as the mean of its samples, and the rotated grid.

use crate::kit::figure::{Figure, LEFT};
use crate::kit::palette::{BLUE, FAINT, INK, VERMILION};
use crate::kit::sketch::{Sketch, flat, xy};
use crate::kit::stage::Drawn;
use glam::{Vec2, Vec3, vec2};
use plotters::prelude::RGBColor;
use raybook::image::tone;
use raybook::sample::filter::Filter;
use raybook::sample::pattern::{regular_grid::regular_grid, rotated_grid};
use std::f32::consts::TAU;

/// Waves per pixel of the wave that is looked at.
const FREQUENCY: f32 = 0.9;

/// The last pixel.
const LAST: u32 = 10;

/// Half of the height of a wave.
const HIGH: f32 = 0.8;

/// The middle of the pixel whose average is drawn below, its half width and the height of the weight 1.
const PIXEL: Vec3 = xy(5.0, -3.6);
const WIDE: f32 = 2.4;
const WEIGHT: f32 = 1.7;

/// Where its samples are, from its middle.
const SAMPLES: [f32; 4] = [-0.72, -0.24, 0.21, 0.78];

/// What `letters` shows.
pub(super) const LETTERS: &str = "The letters of this lesson. Above: a wave of f waves per pixel, seen at one point of each pixel number k, looks \
    like a slow wave. Below: the samples Lᵢ of a pixel lie at the places xᵢ, counted from its middle. Each sample counts with the weight \
    w(xᵢ).";

/// A wave that is looked at once in each pixel, and the weighted samples of one pixel.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn letters() -> Figure {
    flat((760, 430), xy(5.2, -1.3), 6.5, |sketch| {
        wave(sketch)?;
        weights(sketch)
    })
}

/// The wave, its samples, and the wave on which they lie, too.
fn wave(sketch: &Sketch) -> Drawn {
    let seen = 1.0 - FREQUENCY;
    let at = |frequency: f32, k: f32| xy(k, HIGH * (TAU * frequency * k).cos());
    let curve = |frequency, points: u32| -> Vec<Vec3> {
        let step = LAST as f32 / points as f32;
        (0..=points)
            .map(|i| at(frequency, step * i as f32))
            .collect()
    };
    sketch.line(&curve(FREQUENCY, 300), BLUE, 3)?;
    for dash in curve(seen, 80).chunks(4) {
        sketch.line(&dash[..3.min(dash.len())], VERMILION, 6)?;
    }
    for k in 0..=LAST {
        sketch.dot(at(FREQUENCY, k as f32), 11, VERMILION)?;
        sketch.label(xy(k as f32, -1.2), Vec2::ZERO, &k.to_string(), INK)?;
    }
    sketch.label(xy(LAST as f32 + 0.55, -1.2), Vec2::ZERO, "k", INK)?;
    let words = format!("true: f = {FREQUENCY} waves per pixel");
    sketch.words(xy(0.0, 1.45), Vec2::ZERO, &words, BLUE, LEFT)?;
    let words = format!("seen: 1 − f = {seen:.1}");
    sketch.words(xy(6.9, 1.45), Vec2::ZERO, &words, VERMILION, LEFT)
}

/// A pixel from the side: the weight over it, and its samples.
fn weights(sketch: &Sketch) -> Drawn {
    let place = |x: f32| PIXEL + xy(WIDE * x, 0.0);
    let weight = |x: f32| WEIGHT * Filter::TENT.weight(vec2(x, 0.0)) * Vec3::Y;
    sketch.line(&[place(-1.5), place(1.5)], INK, 4)?;
    for edge in [-0.5, 0.5] {
        sketch.dashes(place(edge), place(edge) + 1.1 * WEIGHT * Vec3::Y, FAINT, 3)?;
    }
    let tent = [-1.0, 0.0, 1.0].map(|x| place(x) + weight(x));
    sketch.line(&tent, BLUE, 6)?;
    for x in SAMPLES {
        sketch.line(&[place(x), place(x) + weight(x)], INK, 3)?;
        sketch.dot(place(x), 11, VERMILION)?;
    }
    let last = SAMPLES[3];
    sketch.label(place(0.0), vec2(0.0, 40.0), "0", INK)?;
    sketch.label(place(last), vec2(0.0, 40.0), "xᵢ", INK)?;
    sketch.words(
        place(last) + weight(last),
        vec2(16.0, -20.0),
        "w(xᵢ)",
        INK,
        LEFT,
    )?;
    sketch.words(
        place(1.5),
        vec2(16.0, 0.0),
        "Lᵢ at each dot",
        VERMILION,
        LEFT,
    )?;
    sketch.words(
        place(-2.0) + 0.75 * WEIGHT * Vec3::Y,
        Vec2::ZERO,
        "the weight w, here a tent",
        BLUE,
        LEFT,
    )
}

/// The corners of a unit square whose lower left corner is here.
fn square(corner: Vec3, size: f32) -> [Vec3; 5] {
    [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0)]
        .map(|(x, y)| corner + size * xy(x, y))
}

/// The grey of a display for a value from 0 to 1.
fn grey(value: f32) -> RGBColor {
    let code = tone::to_byte(value);
    RGBColor(code, code, code)
}

/// The brightness of the object and of what is behind it, and where the edge between them meets the pixel's lower and upper side.
const DARK: f32 = 0.12;
const BRIGHT: f32 = 0.92;
const EDGE: [f32; 2] = [0.42, 0.6];

/// What `mean` shows.
pub(super) const MEAN: &str = "Supersampling in one pixel: places, colours, mean.";

/// A pixel with four places, their four colours, and the colour that the pixel gets.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn mean() -> Figure {
    let places = rotated_grid::of(4, rotated_grid::rotated_grid);
    let colour = |p: &Vec2| {
        let edge = EDGE[0] + p.y * (EDGE[1] - EDGE[0]);
        if p.x < edge { DARK } else { BRIGHT }
    };
    let sum: f32 = places.iter().map(colour).sum();
    let mean = sum / places.len() as f32;
    flat((720, 300), xy(1.45, 0.53), 1.3, |sketch| {
        let [pixel, colours, whole] = [0.0, 1.3, 1.9].map(|x| xy(x, 0.0));
        sketch.area(&square(pixel, 1.0), grey(BRIGHT), 1.0)?;
        let edge = [xy(EDGE[0], 0.0), xy(EDGE[1], 1.0)];
        sketch.area(&[pixel, edge[0], edge[1], xy(0.0, 1.0)], grey(DARK), 1.0)?;
        sketch.line(&square(pixel, 1.0), INK, 4)?;
        let mut from_top = places.clone();
        from_top.sort_by(|p, q| q.y.total_cmp(&p.y));
        let step = 1.0 / places.len() as f32;
        for (i, p) in from_top.iter().enumerate() {
            sketch.dot(p.extend(0.0), 16, VERMILION)?;
            sketch.dot(p.extend(0.0), 9, grey(colour(p)))?;
            let tile = square(colours + xy(0.0, 1.0 - step * (i as f32 + 0.9)), 0.8 * step);
            sketch.area(&tile, grey(colour(p)), 1.0)?;
            sketch.line(&tile, INK, 3)?;
        }
        sketch.area(&square(whole, 1.0), grey(mean), 1.0)?;
        sketch.line(&square(whole, 1.0), INK, 4)?;
        sketch.arrow(xy(1.05, 0.5), xy(1.25, 0.5), INK, 5)?;
        sketch.arrow(xy(1.6, 0.5), xy(1.85, 0.5), INK, 5)?;
        let count = places.len();
        for (x, words) in [
            (0.5, format!("{count} places")),
            (1.4, format!("{count} colours")),
            (2.4, "their mean".to_owned()),
        ] {
            sketch.label(xy(x, 1.0), vec2(0.0, -34.0), &words, INK)?;
        }
        Ok(())
    })
}

/// What `turned` shows.
pub(super) const TURNED: &str = "Four samples in a pixel. A vertical edge that moves to the right passes the left pattern in two steps, and the \
    right one in four.";

/// The radius of the arc that shows by how much the samples are turned, as a share of the pixel's side.
const ARC: f32 = 0.3;

/// The 2 × 2 grid, and the rotated one, each in its pixel.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn turned() -> Figure {
    let regular = regular_grid(2, 2);
    let rotated = rotated_grid::of(4, rotated_grid::rotated_grid);
    let leftmost = rotated
        .iter()
        .copied()
        .reduce(|p, q| if q.x < p.x { q } else { p });
    let topmost = rotated
        .iter()
        .copied()
        .reduce(|p, q| if q.y > p.y { q } else { p });
    let (apex, top) = (leftmost.unwrap_or_default(), topmost.unwrap_or_default());
    let angle = (top - apex).to_angle();
    let name = format!("rotated by arctan ½ = {:.1}°", angle.to_degrees());
    let corner = xy(1.4, 0.0);
    flat((720, 330), xy(1.2, 0.5), 1.42, |sketch| {
        pattern(sketch, Vec3::ZERO, "2 × 2 grid", &regular)?;
        sketch.arc(corner + apex.extend(0.0), ARC, [0.0, angle], INK, 4)?;
        pattern(sketch, corner, &name, &rotated)
    })
}

/// Four points in a pixel, with the columns and the rows that they have.
fn pattern(sketch: &Sketch, corner: Vec3, name: &str, points: &[Vec2]) -> Drawn {
    let on_page = |p: Vec2| corner + p.extend(0.0);
    for p in points {
        sketch.line(
            &[on_page(vec2(p.x, 0.0)), on_page(vec2(p.x, 1.0))],
            FAINT,
            3,
        )?;
        sketch.line(
            &[on_page(vec2(0.0, p.y)), on_page(vec2(1.0, p.y))],
            FAINT,
            3,
        )?;
    }
    sketch.line(&square(corner, 1.0), INK, 4)?;
    let mut around = points.to_vec();
    around.sort_by(|p, q| (p - 0.5).to_angle().total_cmp(&(q - 0.5).to_angle()));
    for (p, q) in around.iter().zip(around.iter().cycle().skip(1)) {
        sketch.dashes(on_page(*p), on_page(*q), BLUE, 4)?;
    }
    let columns = |at: fn(&Vec2) -> f32| {
        let mut each: Vec<_> = points.iter().map(at).collect();
        each.sort_by(f32::total_cmp);
        each.dedup_by(|a, b| (*a - *b).abs() < 1e-3);
        each.len()
    };
    for p in points {
        sketch.dot(on_page(*p), 15, VERMILION)?;
    }
    let words = format!("{} columns, {} rows", columns(|p| p.x), columns(|p| p.y));
    sketch.label(on_page(vec2(0.5, 1.0)), vec2(0.0, -34.0), name, INK)?;
    sketch.label(on_page(vec2(0.5, 0.0)), vec2(0.0, 40.0), &words, INK)
}
