//! The letters of the lesson: from radiance to a byte of the display.

use crate::kit::figure::Figure;
use crate::kit::palette::{BLUE, FAINT, INK, VERMILION};
use crate::kit::sketch::{Sketch, flat, xy};
use crate::kit::stage::Drawn;
use glam::{Vec2, Vec3, vec2};
use plotters::prelude::WHITE;
use raybook::image::tone::{encode_srgb, to_byte};

/// The stops by which the example is exposed, and its radiance.
const STOPS: f32 = 1.0;
const RADIANCE: f32 = 1.0;

/// The steps: what each does, and what it is called, at these x.
const STEPS: [(f32, &str, &str); 3] = [
    (1.75, "× 2ˢ", "exposure"),
    (3.75, "L/(1 + L)", "tone curve"),
    (5.75, "v → c", "display code"),
];

/// Half of the width and of the height of a step.
const HALF: Vec2 = vec2(0.6, 0.32);

/// What the diagram shows.
pub(super) const CAPTION: &str = "The letters of this lesson. A colour has the radiances R, G and B. The exposure has s stops. L is the luminance, v \
    is a linear value for the display, and c is the sRGB code of v.";

/// Draws the steps, what goes from each to the next, and an example.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    let exposed = RADIANCE * STOPS.exp2();
    let value = exposed / (1.0 + exposed);
    let values = [
        (0.7, "R, G, B", "0 … ∞", format!("{RADIANCE}")),
        (2.75, "L", "0 … ∞", format!("{exposed}")),
        (4.75, "v", "0 … 1", format!("{value:.3}")),
        (6.85, "255·c", "0 … 255", to_byte(value).to_string()),
    ];
    flat((760, 300), xy(3.75, -0.6), 2.95, |sketch| {
        sketch.arrow(xy(0.2, 0.0), xy(7.3, 0.0), INK, 4)?;
        for (x, does, name) in STEPS {
            step(sketch, xy(x, 0.0), does, name)?;
        }
        sketch.dashes(xy(0.2, -0.95), xy(7.3, -0.95), FAINT, 3)?;
        for (x, name, range, example) in &values {
            sketch.label(xy(*x, 0.3), Vec2::ZERO, name, VERMILION)?;
            sketch.label(xy(*x, -1.2), Vec2::ZERO, range, INK)?;
            sketch.label(xy(*x, -1.6), Vec2::ZERO, example, VERMILION)?;
        }
        sketch.label(
            xy(STEPS[0].0, -1.6),
            Vec2::ZERO,
            &format!("s = {STOPS}"),
            INK,
        )?;
        let code = format!("c = {:.3}", encode_srgb(value));
        sketch.label(xy(STEPS[2].0, -1.6), Vec2::ZERO, &code, INK)?;
        let words = "example: a grey of radiance 1, one stop more";
        sketch.label(xy(3.75, -1.95), Vec2::ZERO, words, INK)
    })
}

/// A step as a box.
fn step(sketch: &Sketch, middle: Vec3, does: &str, name: &str) -> Drawn {
    let corners = [
        (-1.0, -1.0),
        (1.0, -1.0),
        (1.0, 1.0),
        (-1.0, 1.0),
        (-1.0, -1.0),
    ];
    let corners = corners.map(|(x, y)| middle + (vec2(x, y) * HALF).extend(0.0));
    sketch.area(&corners, WHITE, 1.0)?;
    sketch.area(&corners, BLUE, 0.15)?;
    sketch.line(&corners, BLUE, 4)?;
    sketch.label(middle, Vec2::ZERO, does, INK)?;
    sketch.label(middle + xy(0.0, -0.55), Vec2::ZERO, name, INK)
}
