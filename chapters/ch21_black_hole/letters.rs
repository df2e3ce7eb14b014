//! The letters of the lesson: a ray that passes a black hole.

use super::bent_rays::path;
use crate::kit::figure::{Figure, LEFT, RIGHT};
use crate::kit::palette::{BLUE, FAINT, GREEN, INK, VERMILION};
use crate::kit::sketch::{flat, xy};
use glam::{Vec3, vec2};
use raybook::render::curved::{HORIZON, PHOTON_SPHERE};

/// The distance at which the ray would pass the middle if it were straight, in radii of the hole.
const IMPACT: f64 = 4.6;

/// The x at which the position and the velocity are drawn.
const HERE: f32 = -3.4;

/// What of the ray is drawn.
const VIEW: [f32; 2] = [-6.3, 6.0];

/// What the diagram shows.
pub(super) const CAPTION: &str = "The letters of this lesson. The photon is at x, counted from the middle of the hole, and moves along v. A straight ray \
    would pass the middle at the distance b, the impact parameter. The real ray leaves turned by the deflection angle α. Lengths are in radii of \
    the hole; r is the length of x.";

/// Draws the hole, the ray, and where it would go if it were straight.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    let (points, _) = path(IMPACT);
    let points = points.into_iter().map(|p| p.as_vec3().with_z(0.0));
    let mut points: Vec<_> = points
        .filter(|p| p.x > VIEW[0] && p.x < VIEW[1] && p.y > -1.6)
        .collect();
    points.dedup_by(|p, q| p.distance(*q) < 0.1);
    let b = IMPACT as f32;
    let (first, last) = (points[0], points[points.len() - 1]);
    let leaves = (last - points[points.len() - 2]).normalize();
    let here = points.iter().position(|p| p.x > HERE).unwrap_or(0);
    let v = (points[here + 1] - points[here]).normalize();
    flat((760, 400), xy(-0.2, 1.8), 7.0, |sketch| {
        sketch.circle(Vec3::ZERO, PHOTON_SPHERE as f32, GREEN, 4)?;
        sketch.disc(Vec3::ZERO, HORIZON as f32, INK, 1.0)?;
        sketch.words(xy(-1.7, -0.6), vec2(0.0, 0.0), "horizon: r = 1", INK, RIGHT)?;
        sketch.words(
            xy(1.75, -0.6),
            vec2(0.0, 0.0),
            "photon sphere: r = 1.5",
            GREEN,
            LEFT,
        )?;
        sketch.dashes(xy(first.x, b), xy(VIEW[1], b), FAINT, 4)?;
        sketch.measure(Vec3::ZERO, xy(0.0, b), INK)?;
        sketch.words(xy(0.0, 0.62 * b), vec2(18.0, 0.0), "b", INK, LEFT)?;
        sketch.line(&points, VERMILION, 5)?;
        sketch.arrow(last - 0.1 * leaves, last, VERMILION, 5)?;
        // Where the last direction, drawn backwards, meets the straight ray.
        let meets = last + (b - last.y) / leaves.y * leaves;
        sketch.dashes(meets, last, FAINT, 3)?;
        sketch.angle(meets, [leaves, Vec3::X], 2.2, "α")?;
        sketch.arrow(Vec3::ZERO, points[here], BLUE, 5)?;
        sketch.label(0.6 * points[here], vec2(-26.0, 20.0), "x", BLUE)?;
        sketch.arrow(points[here], points[here] + 1.5 * v, VERMILION, 9)?;
        sketch.label(points[here] + 0.8 * v, vec2(0.0, -40.0), "v", VERMILION)?;
        sketch.dot(points[here], 11, INK)
    })
}
