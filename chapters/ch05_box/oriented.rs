//! A pencil in a box along the axes, and in one that is turned with it.

use crate::kit::figure::Figure;
use crate::kit::palette::{BLUE, INK, ORANGE, VERMILION};
use crate::kit::sketch::{flat, xy};
use glam::{Vec2, Vec3, vec2};
use raybook::math::aabb::Aabb;

/// Half of the length and of the thickness of the pencil, and its angle.
const HALF: Vec2 = vec2(1.2, 0.09);
const ANGLE: f32 = 0.6;

/// How much wider than the pencil the boxes are drawn.
const MARGIN: f32 = 0.05;

/// The middle of the second pencil; the first is at the origin.
const SECOND: Vec3 = xy(3.0, 0.0);

/// A ray that passes the pencils: from its start, along this.
const RAY: [Vec3; 2] = [xy(-1.35, 0.35), xy(1.6, 0.75)];

/// What the diagram shows.
pub(super) const CAPTION: &str = "The same pencil twice. Most of its axis-aligned box is empty, and the ray must be tested against the pencil. The \
    oriented box fits, and the ray misses it.";

/// Draws both.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    let turned = |half: Vec2| {
        [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| {
            Vec2::from_angle(ANGLE)
                .rotate(vec2(x, y) * half)
                .extend(0.0)
        })
    };
    let pencil = turned(HALF);
    let bounds = Aabb::of(pencil).grown(MARGIN);
    let (min, max) = (bounds.min, bounds.max);
    let aligned = [min, min.with_x(max.x), max, max.with_x(min.x)].map(|p| p.with_z(0.0));
    let oriented = turned(HALF + MARGIN);
    flat((760, 300), xy(1.5, -0.1), 2.5, |sketch| {
        for (middle, outline, words) in [
            (Vec3::ZERO, aligned, "axis-aligned: a ray gets in"),
            (SECOND, oriented, "oriented: the ray misses"),
        ] {
            sketch.area(&pencil.map(|p| middle + p), ORANGE, 0.8)?;
            let [a, b, c, d] = outline.map(|p| middle + p);
            sketch.line(&[a, b, c, d, a], BLUE, 5)?;
            let [from, along] = RAY;
            sketch.arrow(middle + from, middle + from + along, VERMILION, 4)?;
            sketch.label(middle + xy(0.0, -1.15), Vec2::ZERO, words, INK)?;
        }
        Ok(())
    })
}
