//! The letters of the lesson: light that arrives from a small solid angle, and light that leaves.

use crate::kit::figure::{Figure, LEFT, RIGHT};
use crate::kit::palette::{BLUE, FAINT, INK, ORANGE, VERMILION};
use crate::kit::sketch::{flat, xy};
use glam::{Vec2, Vec3, vec2};
use std::f32::consts::{FRAC_PI_2, PI};

/// The surface point.
const POINT: Vec3 = Vec3::ZERO;

/// The angles of the arriving and of the leaving direction to the normal, to the left and to the right, in radians.
const ARRIVES: f32 = 0.68;
const LEAVES: f32 = 0.9;

/// Half of the angle of the cone from which the light arrives.
const CONE: f32 = 0.14;

/// What the diagram shows.
pub(super) const CAPTION: &str = "The letters of this lesson. At the surface point x with normal n, light of radiance Lᵢ arrives from the small \
    solid angle dωᵢ around the direction ωᵢ, and makes the irradiance dE. Light of radiance Lₒ leaves in the direction ωₒ. Both directions \
    point away from x.";

/// Draws the half sphere of directions above a point, from the side.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    let to = |angle: f32| Vec2::from_angle(FRAC_PI_2 + angle).extend(0.0);
    let [arrives, leaves] = [to(ARRIVES), to(-LEAVES)];
    flat((720, 380), xy(0.0, 0.55), 1.5, |sketch| {
        sketch.arc(POINT, 1.0, [0.0, PI], FAINT, 4)?;
        sketch.line(&[xy(-1.3, 0.0), xy(1.3, 0.0)], INK, 7)?;
        sketch.arrow(POINT, 1.15 * Vec3::Y, INK, 4)?;
        sketch.words(1.15 * Vec3::Y, vec2(20.0, 10.0), "n", INK, LEFT)?;

        let rim = [to(ARRIVES + CONE), to(ARRIVES - CONE)];
        sketch.area(&[POINT, rim[0], arrives, rim[1]], ORANGE, 0.35)?;
        let across = 0.5 * (rim[1] - rim[0]);
        let middle = 0.5 * (rim[0] + rim[1]);
        let cap: Vec<_> = (0..=60)
            .map(|i| {
                let turn = Vec2::from_angle(2.0 * PI * i as f32 / 60.0);
                middle + turn.x * across + 0.35 * turn.y * across.length() * arrives
            })
            .collect();
        sketch.area(&cap, ORANGE, 0.7)?;
        sketch.arrow(1.1 * arrives, POINT, VERMILION, 7)?;
        sketch.words(
            1.1 * arrives,
            vec2(-16.0, -22.0),
            "dωᵢ around ωᵢ",
            INK,
            RIGHT,
        )?;
        sketch.words(0.6 * arrives, vec2(-64.0, 24.0), "Lᵢ", VERMILION, RIGHT)?;
        sketch.angle(POINT, [Vec3::Y, arrives], 0.33, "θᵢ")?;

        sketch.arrow(POINT, leaves, BLUE, 7)?;
        sketch.words(leaves, vec2(20.0, -12.0), "ωₒ", BLUE, LEFT)?;
        sketch.words(0.6 * leaves, vec2(10.0, 34.0), "Lₒ", BLUE, LEFT)?;
        sketch.dot(POINT, 11, INK)?;
        sketch.label(POINT, vec2(0.0, 40.0), "x", INK)?;
        sketch.label(xy(-0.62, 0.0), vec2(0.0, 44.0), "dE = Lᵢ cos θᵢ dωᵢ", INK)
    })
}
