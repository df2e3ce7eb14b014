//! The letters of the lesson: a direction at a mirror, cut into its two parts.

use crate::kit::figure::{Figure, LEFT, RIGHT};
use crate::kit::palette::{BLUE, INK, VERMILION};
use crate::kit::sketch::{flat, xy};
use glam::{Vec3, vec2};
use raybook::material::mirror::reflect;
use raybook::math::dir3::Dir3;

/// The direction that arrives.
const ARRIVES: Vec3 = xy(4.0, -3.0);

/// How far below the mirror the parts along it are drawn.
const BELOW: Vec3 = xy(0.0, -0.1);

/// What the diagram shows.
pub(super) const CAPTION: &str = "The letters of this lesson. All three directions have length 1. The ray arrives in the direction i, which is \
    cut into i∥ along the mirror and i⊥ perpendicular to it. The mirrored direction m has −i⊥ instead. The mirror's normal is n.";

/// Draws the direction that arrives, the mirrored one, and their parts.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    let n = Dir3::Y;
    let i = Dir3::new_or(ARRIVES, Dir3::X);
    let m = reflect(i, n);
    let across = i.dot(*n) * *n;
    let along = *i - across;
    flat((720, 340), xy(0.0, 0.36), 1.35, |sketch| {
        sketch.line(&[xy(-1.2, 0.0), xy(1.2, 0.0)], INK, 7)?;
        sketch.arrow(Vec3::ZERO, *n * 0.85, INK, 4)?;
        sketch.words(*n * 0.85, vec2(20.0, 4.0), "n", INK, LEFT)?;
        for (from, along, colour, names, end, side) in [
            (-*i, along, VERMILION, ["i", "i⊥", "i∥"], RIGHT, -1.0),
            (*m, along, BLUE, ["m", "−i⊥", "i∥"], LEFT, 1.0),
        ] {
            let foot = from.with_y(0.0);
            let [whole, part] = if side < 0.0 {
                [[from, Vec3::ZERO], [from, foot]]
            } else {
                [[Vec3::ZERO, from], [foot, from]]
            };
            sketch.arrow(part[0], part[1], colour, 4)?;
            sketch.words(
                0.5 * foot + 0.5 * from,
                vec2(side * 20.0, 0.0),
                names[1],
                colour,
                end,
            )?;
            let start = BELOW + foot.min(Vec3::ZERO);
            sketch.arrow(start, start + along, colour, 4)?;
            sketch.label(start + 0.5 * along, vec2(0.0, 40.0), names[2], colour)?;
            sketch.arrow(whole[0], whole[1], colour, 8)?;
            sketch.label(0.55 * from, vec2(-side * 24.0, -24.0), names[0], colour)?;
        }
        Ok(())
    })
}
