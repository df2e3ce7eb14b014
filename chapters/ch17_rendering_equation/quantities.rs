//! Flux, intensity, irradiance and radiance: of the same light, four parts.

use crate::kit::figure::Figure;
use crate::kit::palette::{BLUE, FAINT, INK, ORANGE, VERMILION};
use crate::kit::sketch::{Sketch, flat, xy};
use crate::kit::stage::Drawn;
use glam::{Vec2, Vec3};
use std::f32::consts::{FRAC_PI_2, TAU};

/// The names of the quantities, what each tells, and its unit.
const QUANTITIES: [[&str; 3]; 4] = [
    ["flux Φ", "all of it", "W"],
    ["intensity I", "in a direction", "W/sr"],
    ["irradiance E", "on a place", "W/m²"],
    ["radiance L", "along a ray", "W/(m² sr)"],
];

/// The distance from one drawing to the next.
const NEXT: f32 = 2.6;

/// Half of the width of a piece of a surface.
const PIECE: f32 = 0.42;

/// What the diagram shows.
pub(super) const CAPTION: &str = "Flux is all light of the lamp. Intensity is the light that goes into a bundle of directions. Irradiance is the light that \
    arrives on a piece of a surface, from wherever. Radiance is the light that arrives on a piece of a surface from a bundle of directions: what \
    one ray carries. θ is the angle to the normal.";

/// Draws the four side by side.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    let middle = |i: usize| xy(NEXT * i as f32, 0.0);
    flat((860, 310), xy(1.5 * NEXT + 0.1, -0.55), 3.7, |sketch| {
        flux(sketch, middle(0))?;
        intensity(sketch, middle(1))?;
        irradiance(sketch, middle(2))?;
        radiance(sketch, middle(3))?;
        for (i, words) in QUANTITIES.iter().enumerate() {
            for (line, words) in words.iter().enumerate() {
                let place = middle(i) + xy(0.0, -1.32 - 0.4 * line as f32);
                sketch.label(
                    place,
                    Vec2::ZERO,
                    words,
                    if line == 0 { VERMILION } else { INK },
                )?;
            }
        }
        Ok(())
    })
}

/// The direction at an angle from the right, upwards.
fn to(angle: f32) -> Vec3 {
    Vec2::from_angle(angle).extend(0.0)
}

fn lamp(sketch: &Sketch, middle: Vec3) -> Drawn {
    sketch.disc(middle, 0.13, ORANGE, 1.0)
}

fn flux(sketch: &Sketch, middle: Vec3) -> Drawn {
    for i in 0..8 {
        let d = to(TAU * i as f32 / 8.0);
        sketch.arrow(middle + 0.2 * d, middle + 0.85 * d, VERMILION, 4)?;
    }
    lamp(sketch, middle)
}

fn intensity(sketch: &Sketch, middle: Vec3) -> Drawn {
    let start = middle - xy(0.8, 0.0);
    for side in [-0.4, 0.4] {
        sketch.dashes(start, start + 1.7 * to(side), FAINT, 4)?;
    }
    sketch.arc(start, 1.7, [-0.4, 0.4], INK, 3)?;
    for angle in [-0.22, 0.0, 0.22] {
        sketch.arrow(
            start + 0.2 * to(angle),
            start + 1.5 * to(angle),
            VERMILION,
            4,
        )?;
    }
    lamp(sketch, start)
}

/// A surface below, with a piece of it marked.
fn surface(sketch: &Sketch, middle: Vec3) -> Result<Vec3, Box<dyn std::error::Error>> {
    let foot = middle - xy(0.0, 0.85);
    sketch.line(&[foot - xy(1.0, 0.0), foot + xy(1.0, 0.0)], INK, 4)?;
    sketch.line(&[foot - xy(PIECE, 0.0), foot + xy(PIECE, 0.0)], BLUE, 14)?;
    Ok(foot)
}

fn irradiance(sketch: &Sketch, middle: Vec3) -> Drawn {
    let foot = surface(sketch, middle)?;
    for (i, angle) in [0.45, 0.2, 0.0, -0.2, -0.45].into_iter().enumerate() {
        let end = foot + xy(PIECE * (i as f32 - 2.0) / 2.4, 0.06);
        sketch.arrow(end + 1.4 * to(FRAC_PI_2 + angle), end, VERMILION, 4)?;
    }
    Ok(())
}

fn radiance(sketch: &Sketch, middle: Vec3) -> Drawn {
    let foot = surface(sketch, middle)?;
    let d = to(FRAC_PI_2 - 0.5);
    for side in [-PIECE, PIECE] {
        let edge = foot + xy(side, 0.0);
        sketch.dashes(edge, edge + 1.6 * d, FAINT, 4)?;
    }
    sketch.dashes(foot, foot + 1.6 * Vec3::Y, INK, 2)?;
    sketch.angle(foot, [d, Vec3::Y], 0.95, "θ")?;
    sketch.arrow(foot + 1.45 * d, foot + 0.06 * d, VERMILION, 5)
}
