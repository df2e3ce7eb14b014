//! The letters of the lesson: three rays and a circle, which is a sphere from the side.

use crate::kit::figure::{Figure, LEFT};
use crate::kit::palette::{BLUE, FAINT, INK, VERMILION};
use crate::kit::sketch::{flat, xy};
use glam::{Vec3, vec2};
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::{Shape, sphere::Sphere};

/// The x at which the rays start.
const START: f32 = -2.6;

/// Their length.
const LENGTH: f32 = 5.6;

/// What the diagram shows.
pub(super) const CAPTION: &str = "The letters of this lesson. The ray starts at o and goes in the direction d, of length 1. The sphere has the \
    centre c and the radius r. At the first root, its normal n points away from c. Above, a ray that touches the sphere has one root, and one \
    that passes by has none.";

/// Draws a sphere, a ray with two roots, one that touches and one that passes by.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    let sphere = Sphere::new(xy(0.7, 0.0), 1.0);
    let c = sphere.center;
    let ray = |y: f32| Ray::new(xy(START, y), Dir3::X);
    let hit = ray(-0.55);
    let roots = [Interval::AHEAD, Interval::new(2.5, f32::INFINITY)];
    let roots = roots.map(|within| sphere.hit(&hit, within).map_or(0.0, |hit| hit.t));
    let [t0, t1] = roots;
    let foot = hit.at(hit.direction.dot(c - hit.origin));
    flat((720, 370), xy(0.2, 0.03), 3.17, |sketch| {
        sketch.disc(c, sphere.radius, BLUE, 0.12)?;
        sketch.circle(c, sphere.radius, BLUE, 5)?;
        for (y, words) in [(1.0, "touches: one root"), (1.32, "passes by: no root")] {
            let ray = ray(y);
            sketch.arrow(ray.origin, ray.at(LENGTH), FAINT, 4)?;
            sketch.words(ray.origin, vec2(6.0, -26.0), words, INK, LEFT)?;
        }
        sketch.dot(ray(1.0).at(c.x - START), 11, INK)?;

        sketch.dashes(c, foot, INK, 3)?;
        let rim = Vec3::new(0.8, 0.6, 0.0);
        sketch.line(&[c, c + rim], INK, 3)?;
        sketch.label(c + 0.55 * rim, vec2(-6.0, -34.0), "r", INK)?;
        sketch.arrow(hit.origin, hit.at(LENGTH), VERMILION, 4)?;
        sketch.arrow(hit.origin, hit.at(1.0), VERMILION, 9)?;
        sketch.label(hit.at(0.6), vec2(0.0, -42.0), "d", VERMILION)?;
        let entry = hit.at(t0);
        sketch.arrow(entry, entry + 0.5 * *sphere.normal_at(entry), BLUE, 6)?;
        sketch.label(
            entry + 0.5 * *sphere.normal_at(entry),
            vec2(-30.0, 0.0),
            "n",
            BLUE,
        )?;
        let (o, below) = (hit.origin, vec2(0.0, 40.0));
        for (p, colour, beside, name) in [
            (o, INK, below, "o"),
            (entry, VERMILION, vec2(4.0, 40.0), "t₀"),
            (foot, INK, below, "p"),
            (hit.at(t1), VERMILION, vec2(24.0, 40.0), "t₁"),
            (c, INK, vec2(-28.0, -10.0), "c"),
        ] {
            sketch.dot(p, 11, colour)?;
            sketch.label(p, beside, name, colour)?;
        }
        sketch.words(
            o,
            vec2(6.0, 144.0),
            "two roots: in at t₀, out at t₁; closest to the centre at p",
            INK,
            LEFT,
        )
    })
}
