//! The plane first, then the inside: two rays that meet the plane of a triangle.

use crate::kit::figure::{Figure, LEFT, RIGHT, figure};
use crate::kit::palette::{BLUE, FAINT, INK, VERMILION};
use crate::kit::sketch::Sketch;
use glam::{Vec3, vec2, vec3};
use raybook::camera::pinhole::Pinhole;
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::{Shape, plane::Plane, triangle::Triangle};

/// The corners of the triangle, which lies on the floor.
const CORNERS: [Vec3; 3] = [
    vec3(-1.3, 0.0, 0.7),
    vec3(0.9, 0.0, 0.9),
    vec3(-0.1, 0.0, -1.1),
];

/// The start of both rays.
const START: Vec3 = vec3(-0.9, 2.1, 0.0);

/// Where they meet the floor.
const AIMS: [Vec3; 2] = [vec3(-0.15, 0.0, 0.1), vec3(1.55, 0.0, 0.2)];

/// What the diagram shows.
pub(super) const CAPTION: &str = "The plane, then the inside. Both rays meet the plane of the triangle. Only the point of the first ray lies \
    inside the three sides.";

/// Draws a triangle in its plane, a ray that hits it and one that meets only the plane.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    let [p0, p1, p2] = CORNERS;
    let triangle = Triangle::new(p0, p1, p2);
    let plane = Plane::through(p0, Dir3::Y);
    let viewer = Pinhole::look_at(
        vec3(0.0, 3.2, 6.6),
        vec3(0.15, 0.75, 0.0),
        Vec3::Y,
        0.05,
        2.0,
    )?;
    figure(720, 360, |canvas| {
        let sketch = Sketch { canvas, viewer };
        let floor =
            [(-2.4, 1.5), (2.7, 1.5), (2.7, -1.6), (-2.4, -1.6)].map(|(x, z)| vec3(x, 0.0, z));
        sketch.area(&floor, BLUE, 0.08)?;
        sketch.line(
            &[floor[0], floor[1], floor[2], floor[3], floor[0]],
            FAINT,
            3,
        )?;
        sketch.area(&CORNERS, BLUE, 0.35)?;
        sketch.line(&[p0, p1, p2, p0], BLUE, 5)?;
        let foot = vec3(-1.65, 0.0, 0.9);
        sketch.arrow(foot, foot + 0.8 * *plane.normal, BLUE, 6)?;
        sketch.words(foot + 0.8 * *plane.normal, vec2(20.0, 0.0), "n", BLUE, LEFT)?;
        sketch.words(vec3(1.6, 0.0, 1.2), vec2(0.0, 0.0), "the plane", INK, LEFT)?;
        for aim in AIMS {
            let ray = Ray::new(START, Dir3::new_or(aim - START, -Dir3::Y));
            let t = plane.hit(&ray, Interval::AHEAD).map_or(0.0, |hit| hit.t);
            let is_inside = triangle.hit(&ray, Interval::AHEAD).is_some();
            let (colour, words, beside, end) = if is_inside {
                (VERMILION, "inside: a hit", -24.0, RIGHT)
            } else {
                (INK, "outside: a miss", 24.0, LEFT)
            };
            sketch.arrow(ray.origin, ray.at(t), colour, 5)?;
            sketch.dot(ray.at(t), 11, colour)?;
            sketch.words(ray.at(0.5 * t), vec2(beside, 0.0), words, colour, end)?;
        }
        sketch.dot(START, 11, INK)?;
        sketch.label(START, vec2(-34.0, 0.0), "o", INK)
    })
}
