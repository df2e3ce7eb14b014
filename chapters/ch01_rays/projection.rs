//! Projection beside ray tracing: from a triangle to its pixels, and from a pixel to its triangle.

use crate::kit::figure::Figure;
use crate::kit::palette::{BLUE, INK, ORANGE, VERMILION};
use crate::kit::sketch::{Sketch, flat, xy};
use crate::kit::stage::Drawn;
use glam::{Vec3, vec2};

/// The distance of the pixels from the eye, and how many there are, of this height each.
const PLANE: f32 = 1.1;
const PIXELS: i32 = 8;
const HIGH: f32 = 0.2;

/// The triangle, seen from the eye.
const TRIANGLE: [Vec3; 3] = [xy(2.15, 0.85), xy(2.75, -0.1), xy(1.95, -0.5)];

/// The pixel whose ray is drawn, counted from the middle upwards.
const PIXEL: i32 = 0;

/// The eye of the second panel.
const SECOND: Vec3 = xy(3.4, 0.0);

/// What the diagram shows.
pub(super) const CAPTION: &str = "The same eye, pixels and triangle. Projection sends the triangle to the pixels. Ray tracing sends a ray through \
    each pixel to the triangles.";

/// Draws both, side by side.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    flat((760, 315), xy(2.93, -0.03), 2.8, |sketch| {
        projection(sketch)?;
        ray_tracing(sketch)
    })
}

/// The corners of the triangle go to the pixels, between which it is then filled.
fn projection(sketch: &Sketch) -> Drawn {
    let seen = TRIANGLE.map(|corner| corner * (PLANE / corner.x));
    let [low, high] = [f32::min, f32::max].map(|best| seen.map(|p| p.y).into_iter().reduce(best));
    let (low, high) = (low.unwrap_or(0.0), high.unwrap_or(0.0));
    panel(sketch, Vec3::ZERO, |pixel| {
        HIGH * (pixel as f32 + 0.5) > low && HIGH * (pixel as f32 + 0.5) < high
    })?;
    for (corner, place) in TRIANGLE.into_iter().zip(seen) {
        sketch.arrow(corner, place, VERMILION, 4)?;
    }
    name(
        sketch,
        Vec3::ZERO,
        "projection",
        "one triangle: which pixels?",
    )
}

/// The ray of one pixel goes to the triangle.
fn ray_tracing(sketch: &Sketch) -> Drawn {
    panel(sketch, SECOND, |pixel| pixel == PIXEL)?;
    let through = xy(PLANE, HIGH * (PIXEL as f32 + 0.5));
    // The side of the triangle that is turned to the eye.
    let [a, _, b] = TRIANGLE.map(Vec3::truncate);
    let d = through.truncate();
    let hit = through * ((a.perp_dot(b - a)) / d.perp_dot(b - a));
    sketch.arrow(SECOND, SECOND + hit, VERMILION, 5)?;
    sketch.dot(SECOND + hit, 11, VERMILION)?;
    name(sketch, SECOND, "ray tracing", "one pixel: which triangle?")
}

/// The eye, the pixels, of which some are marked, and the triangle.
fn panel(sketch: &Sketch, eye: Vec3, is_marked: impl Fn(i32) -> bool) -> Drawn {
    let corners = TRIANGLE.map(|corner| eye + corner);
    sketch.area(&corners, BLUE, 0.3)?;
    sketch.line(&[corners[0], corners[1], corners[2], corners[0]], BLUE, 4)?;
    for pixel in -PIXELS / 2..PIXELS / 2 {
        let [low, high] = [pixel, pixel + 1].map(|i| HIGH * i as f32);
        let square = [(0.0, low), (0.12, low), (0.12, high), (0.0, high)];
        let square = square.map(|(x, y)| eye + xy(PLANE - 0.06 + x, y));
        if is_marked(pixel) {
            sketch.area(&square, ORANGE, 1.0)?;
        }
        let [a, b, c, d] = square;
        sketch.line(&[a, b, c, d, a], INK, 3)?;
    }
    sketch.dot(eye, 13, INK)?;
    sketch.label(eye, vec2(-4.0, 40.0), "eye", INK)
}

/// What a panel is called above, and what it asks below.
fn name(sketch: &Sketch, eye: Vec3, above: &str, below: &str) -> Drawn {
    sketch.label(eye + xy(1.35, 1.1), vec2(0.0, -10.0), above, INK)?;
    sketch.label(eye + xy(1.35, -1.1), vec2(0.0, 24.0), below, INK)
}
