//! The letters of the lesson: a ray, the point that it hits, and what is asked there.

use crate::kit::figure::{Figure, LEFT};
use crate::kit::palette::{BLUE, FAINT, GREEN, INK, ORANGE, PURPLE, VERMILION};
use crate::kit::sketch::{flat, xy};
use glam::{Vec3, vec2};
use raybook::material::mirror::reflect;
use raybook::math::dir3::Dir3;

/// The eye, the point that its ray hits, and the lamp.
const EYE: Vec3 = xy(-2.5, 1.6);
const POINT: Vec3 = Vec3::ZERO;
const LAMP: Vec3 = xy(1.5, 1.9);

/// The ball whose top the point is: its radius.
const RADIUS: f32 = 4.5;

/// The length of a direction on the page.
const LENGTH: f32 = 1.0;

/// What the diagram shows.
pub(super) const CAPTION: &str = "The letters of this lesson. A ray in the direction d meets a surface at x, with the normal n. From x, the direction v \
    points back to the viewer, and l to a lamp of intensity I at the distance r. The mirror direction of l is m.";

/// Draws them.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    let n = Dir3::Y;
    let l = Dir3::new_or(LAMP - POINT, n);
    let m = reflect(-l, n);
    let d = (POINT - EYE).normalize();
    flat((760, 400), xy(0.0, 0.82), 3.0, |sketch| {
        sketch.arc(POINT - RADIUS * *n, RADIUS, [1.05, 2.09], INK, 7)?;
        let miss = xy(0.6, 2.05);
        sketch.arrow(EYE, miss, FAINT, 4)?;
        sketch.words(miss, vec2(-180.0, -26.0), "no hit: the backdrop", INK, LEFT)?;
        sketch.line(&[EYE, POINT], VERMILION, 4)?;
        sketch.arrow(EYE, EYE + LENGTH * d, VERMILION, 9)?;
        sketch.label(EYE + 0.7 * d, vec2(-10.0, 44.0), "d", VERMILION)?;
        sketch.dashes(POINT, LAMP, ORANGE, 4)?;
        sketch.label(0.72 * LAMP, vec2(28.0, 20.0), "r", INK)?;
        sketch.disc(LAMP, 0.12, ORANGE, 1.0)?;
        sketch.words(LAMP, vec2(46.0, 0.0), "I", INK, LEFT)?;
        for (direction, name, colour) in [
            (*n, "n", INK),
            (*l, "l", BLUE),
            (*m, "m", PURPLE),
            (-d, "v", GREEN),
        ] {
            let tip = POINT + LENGTH * direction;
            sketch.arrow(POINT, tip, colour, 7)?;
            let side = vec2(-direction.y, -direction.x).normalize_or_zero();
            let beside = if name == "n" {
                vec2(26.0, 8.0)
            } else {
                34.0 * side
            };
            sketch.label(tip, beside, name, colour)?;
        }
        sketch.dot(EYE, 13, INK)?;
        sketch.label(EYE, vec2(0.0, -36.0), "eye", INK)?;
        sketch.dot(POINT, 11, INK)?;
        sketch.label(POINT, vec2(0.0, 40.0), "x", INK)?;
        let words = "mirror: trace one more ray; glass: trace two more rays";
        sketch.label(xy(0.0, -0.5), vec2(0.0, 0.0), words, INK)
    })
}
