//! The letters of the lesson: the directions at a lit point.

use crate::kit::figure::{Figure, LEFT, RIGHT};
use crate::kit::palette::{BLUE, GREEN, INK, ORANGE, PURPLE, VERMILION};
use crate::kit::sketch::{flat, xy};
use glam::{Vec3, vec2};
use raybook::material::mirror::reflect;
use raybook::math::dir3::Dir3;

/// The point, the lamp, and where the viewer is.
const POINT: Vec3 = Vec3::ZERO;
const LAMP: Vec3 = xy(-2.0, 2.0);
const VIEWER: Vec3 = xy(2.6, 1.3);

/// The length of a direction on the page.
const LENGTH: f32 = 1.75;

/// What the diagram shows.
pub(super) const CAPTION: &str = "The letters of this lesson. All directions have length 1 and point away from the surface: n is the normal, l \
    goes to the light, v to the viewer, m is the mirror direction of l, and h is halfway between l and v. The lamp is at the distance r.";

/// Draws a lit point, with the directions from which its colour follows.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    let n = Dir3::Y;
    let [l, v] = [LAMP, VIEWER].map(|to| Dir3::new_or(to - POINT, n));
    let m = reflect(-l, n);
    let h = Dir3::new_or(*l + *v, n);
    flat((720, 380), xy(0.2, 0.98), 2.6, |sketch| {
        sketch.line(&[xy(-2.2, 0.0), xy(2.6, 0.0)], INK, 7)?;
        sketch.angle(POINT, [*n, *l], 0.62, "θ")?;
        sketch.angle(POINT, [*m, *n], 0.7, "θ")?;
        sketch.angle(POINT, [*v, *m], 1.1, "δ")?;
        sketch.dashes(POINT, LAMP, ORANGE, 3)?;
        sketch.disc(LAMP, 0.13, ORANGE, 1.0)?;
        sketch.words(LAMP, vec2(50.0, -8.0), "lamp of intensity I", INK, LEFT)?;
        sketch.words(0.75 * LAMP, vec2(-22.0, 14.0), "r", INK, RIGHT)?;
        for (d, name, colour) in [
            (n, "n", INK),
            (l, "l", VERMILION),
            (m, "m", BLUE),
            (v, "v", GREEN),
            (h, "h", PURPLE),
        ] {
            let tip = POINT + LENGTH * *d;
            sketch.arrow(POINT, tip, colour, 6)?;
            let beyond = sketch.at(tip + 0.1 * *d) - sketch.at(tip);
            let aside = if name == "l" {
                vec2(-34.0, 14.0)
            } else {
                beyond
            };
            sketch.label(tip, aside, name, colour)?;
        }
        sketch.dot(POINT, 11, INK)?;
        sketch.label(POINT, vec2(0.0, 40.0), "arrives: i = I/r²", INK)
    })
}
