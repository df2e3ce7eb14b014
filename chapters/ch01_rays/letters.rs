//! The letters of the lesson: the camera from the side.

use crate::kit::figure::{Figure, LEFT, RIGHT};
use crate::kit::palette::{BLUE, INK, VERMILION};
use crate::kit::sketch::{flat, xy};
use glam::{Vec3, vec2};
use raybook::camera::{Camera, pinhole::Pinhole};

/// The place on the film at which the ray passes, from the left and from the top.
const FILM: [f32; 2] = [0.5, 0.24];

/// What the diagram shows.
pub(super) const CAPTION: &str = "The letters of this lesson, from the side. The ray r(t) starts at the focal point o, has the direction d of \
    length 1, and passes through the point q of the image plane. The plane is H high and the camera's view is α high. The axis “right”, \
    the width W and the coordinate u point out of the page, towards you.";

/// Draws a camera that looks to the right, one of its rays, and what is measured.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    let camera = Pinhole {
        plane: vec2(2.0, 2.0),
        ..Pinhole::look_at(Vec3::ZERO, Vec3::X, Vec3::Y, 2.1, 1.0)?
    };
    let (o, f, high) = (camera.focal_point, camera.focal_length, camera.plane.y);
    let ray = camera.central_ray(FILM.into());
    let q = ray.at(f / ray.direction.x);
    let [bottom, top] = [-0.5, 0.5].map(|side| xy(f, side * high));
    flat((720, 400), xy(1.9, -0.05), 3.0, |sketch| {
        sketch.arrow(o, xy(4.4, 0.0), INK, 2)?;
        sketch.words(xy(4.4, 0.0), vec2(0.0, 36.0), "forward", INK, RIGHT)?;
        sketch.dashes(o, top, INK, 2)?;
        sketch.dashes(o, bottom, INK, 2)?;
        sketch.line(&[bottom, top], BLUE, 8)?;
        sketch.arrow(o, xy(0.0, 0.75), INK, 2)?;
        sketch.label(xy(0.0, 0.75), vec2(0.0, -30.0), "up", INK)?;
        sketch.angle(o, [bottom - o, top - o], 0.5, "α")?;

        let end = ray.at(4.3);
        sketch.arrow(o, end, VERMILION, 4)?;
        sketch.label(end, vec2(-20.0, -46.0), "r(t)", VERMILION)?;
        sketch.arrow(o, ray.at(1.0), VERMILION, 9)?;
        sketch.label(ray.at(1.2), vec2(0.0, -34.0), "d", VERMILION)?;
        sketch.dot(o, 11, INK)?;
        sketch.label(o, vec2(-34.0, 20.0), "o", INK)?;
        sketch.dot(q, 11, VERMILION)?;
        sketch.label(q, vec2(-34.0, -34.0), "q", VERMILION)?;

        let below = xy(0.0, -0.5 * high - 0.15);
        sketch.measure(o + below, xy(f, 0.0) + below, INK)?;
        sketch.label(xy(0.5 * f, 0.0) + below, vec2(0.0, 2.0), "f", INK)?;
        let beside = xy(0.35, 0.0);
        sketch.measure(top + beside, q + beside, BLUE)?;
        sketch.words(0.5 * (top + q) + beside, vec2(20.0, 0.0), "v·H", BLUE, LEFT)?;
        let beside = xy(1.15, 0.0);
        sketch.measure(bottom + beside, top + beside, BLUE)?;
        sketch.words(xy(f, -0.6) + beside, vec2(20.0, 0.0), "H", BLUE, LEFT)
    })
}
