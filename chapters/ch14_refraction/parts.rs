//! A ray at a flat surface, and its two answers: each direction as the sum of a part along the surface and a part that is
//! perpendicular to it.

use crate::kit::figure::{CENTRE, Figure, LEFT, RIGHT};
use crate::kit::palette::{BLUE, FAINT, INK, SKY, VERMILION};
use crate::kit::sketch::{Sketch, flat, xy};
use crate::kit::stage::Drawn;
use glam::{Vec3, vec2};
use plotters::style::text_anchor::Pos;
use raybook::material::mirror::reflect;
use raybook::material::refract::refract;
use raybook::math::dir3::Dir3;

/// The angle θ₁ at which the ray arrives, in degrees.
const INCIDENCE: f32 = 50.0;

/// The index of the medium from which the ray comes, air.
const AIR: f32 = 1.0;

/// Width and height of the figure, in pixels.
const SIZE: (u32, u32) = (720, 480);

/// Height of what is seen; the directions have the length 1.
const HEIGHT: f32 = 2.5;

/// The distance between the surface and the arrows along it.
const BESIDE: f32 = 0.035;

/// The radius of the arcs that show θ₁ and θ₂.
const ARC: f32 = 0.3;

/// The length at which the normal is drawn: at its length, 1, its end would be on the circle.
const NORMAL: f32 = 0.85;

/// What the diagram shows, with the angle θ₂ for a medium of this index.
pub(super) fn caption(index: f32) -> String {
    let sine = AIR / index * INCIDENCE.to_radians().sin();
    format!(
        "The directions of the ray that arrives (i, black, at θ₁ = {INCIDENCE}°), of the ray that is reflected (m, vermilion) and of the \
        ray that goes through (t, blue), each as the sum of a part along the surface (∥) and a part that is perpendicular to the surface \
        (⊥). All three directions end on a circle of radius 1, so their parts along the surface have the lengths sin θ₁, sin θ₁ and \
        sin θ₂. With η₁ = {AIR} and η₂ = {index}: sin θ₂ = (η₁/η₂) sin θ₁ = {sine:.3}, and θ₂ = {:.1}°.",
        sine.asin().to_degrees()
    )
}

/// The directions i, m and t and their parts, on a circle of radius 1, for a medium below of this index.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn diagram(index: f32) -> Figure {
    let (sine, cosine) = INCIDENCE.to_radians().sin_cos();
    let arrives = Dir3::new_or(xy(sine, -cosine), Dir3::Y);
    let [i, m] = [*arrives, *reflect(arrives, Dir3::Y)];
    let t = refract(arrives, Dir3::Y, AIR, index).map_or(i, |t| *t);
    flat(SIZE, Vec3::ZERO, HEIGHT, |sketch| {
        let aspect = SIZE.0 as f32 / SIZE.1 as f32;
        surface(sketch, aspect)?;
        let [along, up] = [Vec3::X, Vec3::Y];
        let part = |from: Vec3, to: Vec3, colour| sketch.arrow(from, to, colour, 5);
        let whole = |from: Vec3, to: Vec3, colour| sketch.arrow(from, to, colour, 9);
        let name = |at: Vec3, [x, y]: [f32; 2], words: &str, colour, end: Pos| {
            sketch.words(at, vec2(x, y), words, colour, end)
        };

        let foot = -sine * along;
        part(-i, foot, INK)?;
        part(foot - BESIDE * up, -BESIDE * up, INK)?;
        whole(-i, Vec3::ZERO, INK)?;
        name(0.5 * (foot - i), [-16.0, 0.0], "i⊥", INK, RIGHT)?;
        name(foot, [0.0, 50.0], "i∥, length sin θ₁", INK, LEFT)?;
        name(-0.7 * i, [20.0, -20.0], "i", INK, LEFT)?;

        let foot = sine * along;
        part(BESIDE * up, foot + BESIDE * up, VERMILION)?;
        part(foot, m, VERMILION)?;
        whole(Vec3::ZERO, m, VERMILION)?;
        name(0.5 * (foot + m), [16.0, 0.0], "m⊥ = −i⊥", VERMILION, LEFT)?;
        name(0.6 * foot, [0.0, -46.0], "m∥ = i∥", VERMILION, CENTRE)?;
        name(0.7 * m, [-20.0, -20.0], "m", VERMILION, RIGHT)?;

        let foot = t.x * along;
        part(-BESIDE * up, foot - BESIDE * up, BLUE)?;
        part(foot, t, BLUE)?;
        whole(Vec3::ZERO, t, BLUE)?;
        name(0.5 * (foot + t), [16.0, 0.0], "t⊥", BLUE, LEFT)?;
        let shorter = "t∥ = (η₁/η₂) i∥, length sin θ₂";
        name(foot, [16.0, 50.0], shorter, BLUE, LEFT)?;
        name(0.7 * t, [-26.0, 16.0], "t", BLUE, RIGHT)?;

        sketch.arrow(Vec3::ZERO, NORMAL * up, INK, 5)?;
        name(NORMAL * up, [20.0, 10.0], "n", INK, LEFT)?;
        sketch.angle(Vec3::ZERO, [up, -i], ARC, "θ₁")?;
        sketch.angle(Vec3::ZERO, [-up, t], ARC, "θ₂")?;
        let [left, right] = [-1.0, 1.0].map(|side| 0.5 * HEIGHT * aspect * side * along);
        let [top, bottom] = [1.0, -1.0].map(|side| 0.5 * HEIGHT * side * up);
        name(left + top, [40.0, 50.0], "η₁ (air)", INK, LEFT)?;
        name(left + bottom, [40.0, -50.0], "η₂ (glass)", INK, LEFT)?;
        let law = "sin θ₂ = (η₁/η₂) sin θ₁";
        name(right + bottom, [-40.0, -50.0], law, INK, RIGHT)
    })
}

/// The two media, the normal's line and the circle of radius 1.
fn surface(sketch: &Sketch, aspect: f32) -> Drawn {
    let [right, down] = [0.5 * HEIGHT * aspect * Vec3::X, -0.5 * HEIGHT * Vec3::Y];
    sketch.area(&[-right, right, right + down, down - right], SKY, 0.3)?;
    sketch.circle(Vec3::ZERO, 1.0, FAINT, 3)?;
    sketch.dashes(-1.15 * Vec3::Y, 1.15 * Vec3::Y, FAINT, 3)?;
    sketch.line(&[-right, right], INK, 3)
}
