//! Directions as points of a dome, and their shadows on the floor: what a density looks like.

use crate::kit::figure::{CENTRE, Figure, figure, text, write};
use crate::kit::palette::{BLUE, FAINT, INK, ORANGE};
use crate::kit::sketch::Sketch;
use crate::kit::stage::Drawn;
use glam::{Vec2, Vec3, vec2, vec3};
use plotters::prelude::RGBColor;
use raybook::camera::pinhole::Pinhole;
use raybook::math::dir3::Dir3;
use raybook::sample::hemisphere::{cosine_hemisphere, uniform_hemisphere};
use std::f32::consts::TAU;

/// Directions in each dome.
const POINTS: u32 = 600;

/// The domes' names, their directions, and the note below each dome.
const DOMES: [(&str, Warp, &str); 2] = [
    (
        "uniform: p = 1/2π",
        uniform_hemisphere,
        "many near the horizon, where directions count for little",
    ),
    (
        "by the cosine: p = cos θ/π",
        cosine_hemisphere,
        "their shadows fill the disc evenly",
    ),
];

/// Where the domes are seen from.
const EYE: Vec3 = vec3(0.0, 2.6, 5.0);

/// Height of the disc with the shadows: below the dome, which would hide the shadows.
const FLOOR: f32 = -0.95;

type Warp = fn(Dir3, Vec2) -> Dir3;

/// Two domes side by side: all directions equally likely, and by the cosine.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    figure(960, 560, |canvas| {
        let halves = canvas.split_evenly((1, 2));
        for ((name, warp, note), half) in DOMES.into_iter().zip(&halves) {
            let (width, height) = half.dim_in_pixel();
            let aspect = width as f32 / height as f32;
            let viewer = Pinhole::look_at(EYE, vec3(0.0, -0.2, 0.0), Vec3::Y, 0.036, aspect)?;
            dome(
                &Sketch {
                    canvas: half,
                    viewer,
                },
                warp,
            )?;
            for (words, y, size) in [(name, 70, 48), (note, height as i32 - 60, 33)] {
                let middle = (width as i32 / 2, y);
                write(half, words, middle, text(size).pos(CENTRE))?;
            }
        }
        Ok(())
    })
}

/// The directions of evenly spread points, the farthest first.
fn dome(sketch: &Sketch, warp: Warp) -> Drawn {
    let disc = circle(|x, y| vec3(x, FLOOR, y));
    sketch.area(&disc, FAINT, 0.25)?;
    sketch.line(&disc, INK, 2)?;
    let mut points: Vec<Vec3> = (0..POINTS)
        .map(|i| {
            let u = vec2(
                (i as f32 + 0.5) / POINTS as f32,
                (0.618_034 * i as f32).fract(),
            );
            *warp(Dir3::Y, u)
        })
        .collect();
    points.sort_by(|a, b| a.z.total_cmp(&b.z));
    for p in &points {
        sketch.dot(vec3(p.x, FLOOR, p.z), 5, ORANGE)?;
    }
    for p in &points {
        let behind = p.z < 0.0;
        sketch.dot(*p, 7, if behind { pale(BLUE) } else { BLUE })?;
    }
    sketch.line(&circle(|x, y| vec3(x, 0.0, y)), INK, 2)?;
    sketch.line(&silhouette(), INK, 2)?;
    sketch.arrow(Vec3::ZERO, 1.2 * Vec3::Y, INK, 5)?;
    sketch.label(1.2 * Vec3::Y, vec2(44.0, 0.0), "n", INK)
}

/// A circle of radius 1 in some plane.
fn circle(plane: impl Fn(f32, f32) -> Vec3) -> Vec<Vec3> {
    let turn = |i: i32| (i as f32 * TAU / 96.0).sin_cos();
    (0..=96).map(turn).map(|(y, x)| plane(x, y)).collect()
}

/// What the eye sees as the dome's edge: where the lines of sight touch the sphere, p · EYE = 1.
fn silhouette() -> Vec<Vec3> {
    let d = EYE.length();
    let (toward, right) = (EYE / d, Vec3::X);
    let (middle, r, up) = (
        toward / d,
        (1.0 - 1.0 / (d * d)).sqrt(),
        toward.cross(right),
    );
    let edge = circle(|x, y| middle + r * (y * right - x * up));
    // It starts at its lowest point.
    edge.into_iter().filter(|p| p.y >= 0.0).collect()
}

/// Half way to white.
fn pale(RGBColor(r, g, b): RGBColor) -> RGBColor {
    let half = |v: u8| v / 2 + 127;
    RGBColor(half(r), half(g), half(b))
}
