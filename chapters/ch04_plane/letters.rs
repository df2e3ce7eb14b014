//! The letters of the lesson: a ray and a plane from the side.

use crate::kit::figure::{Figure, LEFT, RIGHT};
use crate::kit::palette::{BLUE, FAINT, INK, VERMILION};
use crate::kit::sketch::{flat, xy};
use glam::{Vec3, vec2};
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::{Shape, plane::Plane};

/// The world's origin.
const ORIGIN: Vec3 = Vec3::ZERO;

/// What the diagram shows.
pub(super) const CAPTION: &str = "The letters of this lesson. The plane has the normal n, of length 1, and the offset c. The ray starts at o, \
    goes in the direction d, and meets the plane at the point p at the distance t.";

/// Draws a plane, its offset from the world's origin, and a ray that meets it.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    let plane = Plane::through(xy(0.0, 0.9), Dir3::Y);
    let n = *plane.normal;
    let ray = Ray::new(xy(1.1, 2.6), Dir3::new_or(xy(2.0, -1.0), Dir3::X));
    let t = plane.hit(&ray, Interval::AHEAD).map_or(0.0, |hit| hit.t);
    let [o, p] = [ray.origin, ray.at(t)];
    let [left, right] = [xy(-0.6, 0.0), xy(7.0, 0.0)];
    flat((720, 350), xy(3.2, 1.35), 3.7, |sketch| {
        let height = plane.offset * n;
        sketch.dashes(left, right, INK, 2)?;
        let below = [left, right, right + height, left + height];
        sketch.area(&below, BLUE, 0.1)?;
        sketch.line(&[left + height, right + height], BLUE, 7)?;
        sketch.words(right, vec2(-30.0, 36.0), "n·x = 0", INK, RIGHT)?;
        sketch.words(right + height, vec2(-30.0, 40.0), "n·x = c", BLUE, RIGHT)?;
        let foot = xy(6.1, 0.0) + height;
        sketch.arrow(foot, foot + n, BLUE, 7)?;
        sketch.words(foot + n, vec2(22.0, 20.0), "n", BLUE, LEFT)?;

        sketch.dot(ORIGIN, 11, INK)?;
        sketch.words(ORIGIN, vec2(-20.0, 40.0), "world's origin", INK, LEFT)?;
        sketch.measure(ORIGIN, height, INK)?;
        sketch.words(0.5 * height, vec2(-20.0, 0.0), "c", INK, RIGHT)?;
        let beside = xy(0.7, 0.0);
        sketch.line(&[beside.with_y(o.y), o], FAINT, 3)?;
        sketch.measure(beside, beside + o.y * n, INK)?;
        sketch.words(beside + 0.72 * o.y * n, vec2(18.0, 0.0), "n·o", INK, LEFT)?;

        sketch.line(&[o, p], VERMILION, 4)?;
        sketch.dashes(p, ray.at(t + 1.6), VERMILION, 3)?;
        sketch.arrow(o, ray.at(1.0), VERMILION, 9)?;
        sketch.label(ray.at(0.65), vec2(14.0, -46.0), "d", VERMILION)?;
        sketch.label(ray.at(0.62 * t), vec2(14.0, -46.0), "t", VERMILION)?;
        sketch.dot(o, 11, INK)?;
        sketch.label(o, vec2(0.0, -42.0), "o", INK)?;
        sketch.dot(p, 11, VERMILION)?;
        sketch.label(p, vec2(26.0, -36.0), "p", VERMILION)
    })
}
