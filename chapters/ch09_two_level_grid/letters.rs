//! The letters of the lesson: a coarse cell that is cut, and an empty one that is not.

use crate::kit::figure::{Figure, LEFT, RIGHT};
use crate::kit::palette::{BLUE, FAINT, INK, ORANGE};
use crate::kit::sketch::{flat, xy};
use glam::{Vec2, Vec3, vec2};

/// The extents of a coarse cell, and the fine cells along each axis.
const EXTENTS: Vec2 = vec2(2.8, 1.5);
const FINE: [u32; 2] = [4, 2];

/// The shapes, as discs: middle and radius.
const SHAPES: [(Vec3, f32); 6] = [
    (xy(0.3, 1.1), 0.07),
    (xy(1.0, 0.5), 0.09),
    (xy(1.18, 1.2), 0.06),
    (xy(1.8, 0.3), 0.08),
    (xy(2.1, 1.06), 0.09),
    (xy(2.52, 0.4), 0.07),
];

/// What the diagram shows.
pub(super) const CAPTION: &str = "The letters of this lesson, for one coarse cell, in the plane. The cell has the extents e and the volume V, and \
    holds n shapes. It is cut into n along x by n along y (by n along z) fine cells. The density λ is the number of fine cells for each shape. An \
    empty cell is not cut.";

/// Draws both.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    let Vec2 { x: wide, y: high } = EXTENTS;
    flat((760, 350), xy(2.0, 0.66), 2.75, |sketch| {
        for i in 1..FINE[0] {
            let x = wide * i as f32 / FINE[0] as f32;
            sketch.line(&[xy(x, 0.0), xy(x, high)], FAINT, 3)?;
        }
        for j in 1..FINE[1] {
            let y = high * j as f32 / FINE[1] as f32;
            sketch.line(&[xy(0.0, y), xy(wide, y)], FAINT, 3)?;
        }
        for (left, width) in [(0.0, wide), (wide, 0.75 * wide)] {
            let corners = [
                (0.0, 0.0),
                (width, 0.0),
                (width, high),
                (0.0, high),
                (0.0, 0.0),
            ];
            sketch.line(&corners.map(|(x, y)| xy(left + x, y)), INK, 7)?;
        }
        for (middle, radius) in SHAPES {
            sketch.disc(middle, radius, ORANGE, 1.0)?;
        }
        let shapes = SHAPES.len();
        let [nx, ny] = FINE;
        let words = format!("n = {shapes} shapes: {nx} × {ny} fine cells");
        sketch.words(xy(0.0, high), vec2(0.0, -36.0), &words, INK, LEFT)?;
        sketch.label(
            xy(wide * 1.375, 0.5 * high),
            Vec2::ZERO,
            "empty: not cut",
            INK,
        )?;
        let below = xy(0.0, -0.15);
        sketch.measure(below, below + wide * Vec3::X, BLUE)?;
        sketch.label(below + 0.5 * wide * Vec3::X, Vec2::ZERO, "eₓ", BLUE)?;
        let left = xy(-0.15, 0.0);
        sketch.measure(left, left + high * Vec3::Y, BLUE)?;
        sketch.words(
            left + 0.5 * high * Vec3::Y,
            vec2(-12.0, 0.0),
            "e along y",
            BLUE,
            RIGHT,
        )?;
        sketch.words(
            xy(0.0, -0.4),
            Vec2::ZERO,
            "volume V, λ·n fine cells altogether",
            INK,
            LEFT,
        )
    })
}
