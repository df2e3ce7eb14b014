//! The letters of the lesson: a shadow ray on its way to the lamp.

use crate::kit::figure::{Figure, LEFT, RIGHT};
use crate::kit::palette::{BLUE, FAINT, INK, ORANGE, VERMILION};
use crate::kit::sketch::{flat, xy};
use glam::{Vec3, vec2};

/// The surface point, its normal and the lamp.
const POINT: Vec3 = Vec3::ZERO;
const NORMAL: Vec3 = Vec3::Y;
const LAMP: Vec3 = xy(3.6, 1.65);

/// The step off the surface and the margin before the lamp, larger than they are.
const STEP: f32 = 0.26;
const MARGIN: f32 = 0.45;

/// The ball in the way, and the ball behind the lamp.
const IN_THE_WAY: (Vec3, f32) = (xy(1.95, 1.15), 0.36);
const BEHIND: (Vec3, f32) = (xy(4.7, 2.07), 0.28);

/// What the diagram shows.
pub(super) const CAPTION: &str = "The letters of this lesson. The surface point is x, with the normal n. The shadow ray starts at o, the step s off the \
    surface, and goes in the direction l. It ends the margin ε before the lamp, which is at the distance d. The ball in the way throws a shadow. \
    The ball behind the lamp does not.";

/// Draws them.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    let o = POINT + STEP * NORMAL;
    let l = (LAMP - o).normalize();
    let end = LAMP - MARGIN * l;
    flat((760, 360), xy(2.4, 0.98), 2.95, |sketch| {
        sketch.line(&[xy(-0.7, 0.0), xy(3.6, 0.0)], INK, 7)?;
        sketch.dashes(xy(-0.7, STEP), xy(3.6, STEP), FAINT, 3)?;
        sketch.measure(xy(-0.45, 0.0), xy(-0.45, STEP), INK)?;
        sketch.words(xy(-0.45, 0.5 * STEP), vec2(-14.0, 0.0), "s", INK, RIGHT)?;
        for ((middle, radius), words, below) in [
            (IN_THE_WAY, "in the way", -1.0),
            (BEHIND, "behind the lamp", 1.0),
        ] {
            sketch.disc(middle, radius, BLUE, 0.3)?;
            let place = middle - below * xy(0.0, radius);
            sketch.label(place, vec2(0.0, 34.0 * below), words, BLUE)?;
        }
        sketch.arrow(o, o + NORMAL, INK, 5)?;
        sketch.label(o + NORMAL, vec2(-28.0, 10.0), "n", INK)?;
        sketch.line(&[o, end], VERMILION, 4)?;
        sketch.dashes(end, LAMP, FAINT, 4)?;
        sketch.arrow(o, o + l, VERMILION, 9)?;
        sketch.label(o + 0.75 * l, vec2(-14.0, -40.0), "l", VERMILION)?;
        sketch.line(
            &[end - 0.1 * xy(-l.y, l.x), end + 0.1 * xy(-l.y, l.x)],
            VERMILION,
            6,
        )?;
        sketch.label(end.midpoint(LAMP), vec2(16.0, 36.0), "ε", INK)?;
        sketch.words(
            o.lerp(LAMP, 0.62),
            vec2(24.0, 36.0),
            "from x to the lamp: d",
            INK,
            LEFT,
        )?;
        sketch.disc(LAMP, 0.14, ORANGE, 1.0)?;
        sketch.dot(POINT, 11, INK)?;
        sketch.label(POINT, vec2(0.0, 40.0), "x", INK)?;
        sketch.dot(o, 9, VERMILION)?;
        sketch.label(o, vec2(-30.0, -22.0), "o", VERMILION)
    })
}
