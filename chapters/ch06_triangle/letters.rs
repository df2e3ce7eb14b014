//! The letters of the lesson: a triangle, its sides, and a ray that meets it.

use crate::kit::figure::{Figure, LEFT};
use crate::kit::palette::{BLUE, FAINT, GREEN, INK, VERMILION};
use crate::kit::sketch::{flat, xy};
use glam::{Vec3, vec2};

/// The corners and the start of the ray, as they appear on the page.
const CORNERS: [Vec3; 3] = [xy(0.0, 0.0), xy(3.3, -0.2), xy(1.2, 1.8)];
const START: Vec3 = xy(4.2, 2.45);

/// The barycentric coordinates b₁ and b₂ of the hit.
const INSIDE: [f32; 2] = [0.35, 0.4];

/// What the diagram shows.
pub(super) const CAPTION: &str = "The letters of this lesson. The triangle has the corners p₀, p₁ and p₂ and the sides e₁ = p₁ − p₀ and e₂ = p₂ − p₀. \
    The ray from o in the direction d meets the triangle at p, at the distance t; s = o − p₀.";

/// Draws them.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    let [p0, p1, p2] = CORNERS;
    let (e1, e2) = (p1 - p0, p2 - p0);
    let [b1, b2] = INSIDE;
    let turn = p0 + b1 * e1;
    let p = turn + b2 * e2;
    flat((720, 400), xy(2.1, 1.1), 3.25, |sketch| {
        sketch.area(&CORNERS, BLUE, 0.12)?;
        sketch.line(&[p1, p2], BLUE, 4)?;
        sketch.dashes(p0, START, FAINT, 4)?;
        sketch.label(p0.lerp(START, 0.62), vec2(-20.0, -34.0), "s", INK)?;
        sketch.arrow(p0, p1, BLUE, 4)?;
        sketch.arrow(p0, p2, BLUE, 4)?;
        sketch.label(p0 + 0.7 * e1, vec2(0.0, 38.0), "e₁", BLUE)?;
        sketch.label(p0 + 0.6 * e2, vec2(-34.0, -12.0), "e₂", BLUE)?;
        sketch.arrow(p0, turn, GREEN, 8)?;
        sketch.arrow(turn, p, GREEN, 8)?;
        sketch.label(p0 + 0.5 * (turn - p0), vec2(0.0, 38.0), "b₁·e₁", GREEN)?;
        sketch.words(
            turn + 0.45 * (p - turn),
            vec2(20.0, 12.0),
            "b₂·e₂",
            GREEN,
            LEFT,
        )?;
        sketch.line(&[START, p], VERMILION, 4)?;
        let d = (p - START).normalize();
        sketch.arrow(START, START + 0.8 * d, VERMILION, 9)?;
        sketch.label(START + 0.55 * d, vec2(10.0, 42.0), "d", VERMILION)?;
        sketch.label(START.lerp(p, 0.62), vec2(4.0, 40.0), "t", VERMILION)?;
        for (corner, name, beside) in [
            (p0, "p₀", vec2(-34.0, 14.0)),
            (p1, "p₁", vec2(36.0, 10.0)),
            (p2, "p₂", vec2(0.0, -36.0)),
            (START, "o", vec2(32.0, 0.0)),
        ] {
            sketch.dot(corner, 10, INK)?;
            sketch.label(corner, beside, name, INK)?;
        }
        sketch.dot(p, 12, VERMILION)?;
        sketch.label(p, vec2(-8.0, -38.0), "p", VERMILION)
    })
}
