//! The letters of the lesson: a ray and the two slabs of a box in the plane.

use crate::kit::figure::{Figure, LEFT, RIGHT};
use crate::kit::palette::{BLUE, FAINT, GREEN, INK, VERMILION};
use crate::kit::sketch::{flat, xy};
use glam::{Vec2, Vec3, vec2};
use raybook::math::{dir3::Dir3, ray::Ray};

/// The lower and the upper corner of the box.
const MIN: Vec3 = xy(1.7, 0.45);
const MAX: Vec3 = xy(4.0, 1.75);

/// What the diagram shows.
pub(super) const CAPTION: &str = "The letters of this lesson, in the plane. The box lies between x₀ and x₁ and between y₀ and y₁. The ray starts at o \
    and goes in the direction d. Below: the interval of t for each slab, and the overlap.";

/// Draws the box, its slabs, a ray through them, and the intervals of the ray.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    let ray = Ray::new(Vec3::ZERO, Dir3::new_or(xy(2.75, 1.0), Dir3::X));
    let (o, d) = (ray.origin, *ray.direction);
    let [x_in, x_out] = [MIN, MAX].map(|corner| (corner.x - o.x) / d.x);
    let [y_in, y_out] = [MIN, MAX].map(|corner| (corner.y - o.y) / d.y);
    flat((760, 430), xy(2.85, 0.62), 3.75, |sketch| {
        let corners = [MIN, MIN.with_x(MAX.x), MAX, MAX.with_x(MIN.x)];
        sketch.area(&corners, FAINT, 0.4)?;
        sketch.line(&[MIN, corners[1], MAX, corners[3], MIN], INK, 3)?;
        for (x, name) in [(MIN.x, "x₀"), (MAX.x, "x₁")] {
            sketch.dashes(xy(x, -0.1), xy(x, 2.2), BLUE, 4)?;
            sketch.label(xy(x, 2.2), vec2(0.0, -28.0), name, BLUE)?;
        }
        for (y, name) in [(MIN.y, "y₀"), (MAX.y, "y₁")] {
            sketch.dashes(xy(0.0, y), xy(5.8, y), GREEN, 4)?;
            sketch.words(xy(0.0, y), vec2(-12.0, 0.0), name, GREEN, RIGHT)?;
        }
        sketch.arrow(o, ray.at(6.0), VERMILION, 4)?;
        sketch.arrow(o, ray.at(1.0), VERMILION, 9)?;
        sketch.label(ray.at(0.6), vec2(14.0, 36.0), "d", VERMILION)?;
        sketch.dot(o, 11, INK)?;
        sketch.label(o, vec2(-30.0, 14.0), "o", INK)?;
        for t in [x_in, x_out] {
            sketch.dot(ray.at(t), 11, BLUE)?;
        }
        for t in [y_in, y_out] {
            sketch.dot(ray.at(t), 11, GREEN)?;
        }
        // Below, t is counted along x: so each end stands below its point.
        let on_axis = |t: f32, y: f32| xy(ray.at(t).x, y);
        for (t, y, colour, name) in [
            ([x_in, x_out], -0.35, BLUE, "slab of x"),
            ([y_in, y_out], -0.6, GREEN, "slab of y"),
        ] {
            sketch.line(&t.map(|t| on_axis(t, y)), colour, 14)?;
            sketch.words(xy(-0.35, y), Vec2::ZERO, name, colour, LEFT)?;
        }
        let [near, far] = [x_in.max(y_in), x_out.min(y_out)];
        sketch.line(&[near, far].map(|t| on_axis(t, -0.85)), VERMILION, 14)?;
        sketch.words(xy(-0.35, -0.85), Vec2::ZERO, "overlap", VERMILION, LEFT)?;
        for (t, name) in [(near, "t near"), (far, "t far")] {
            sketch.line(&[on_axis(t, -0.25), on_axis(t, -0.95)], INK, 2)?;
            sketch.label(on_axis(t, -1.0), vec2(0.0, 18.0), name, VERMILION)?;
        }
        Ok(())
    })
}
